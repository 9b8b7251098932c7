// Files that a person opens, damaged at random: each is read, or refused with an Error of one line. For a build with
// sanitizers, which end the program at the first access or number that is not allowed.
//   fuzz model|image|settings SECONDS [SEED [FIRST]]
// Every input follows from seed and number, and the last number is printed when a sanitizer ends the program: with it
// as FIRST the same input comes again at once.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/common_interface_defs.h>
#endif

#include "../broken_gltf/gltf_writer.h"
#include "core/error.h"
#include "image/foreign_image.h"
#include "scene/gltf_scene.h"
#include "settings_file.h"

namespace {

using namespace timeshade;
using test::ByteList;

std::uint32_t seed = 1;
std::uint64_t number = 0;

void sayWhere() { std::fprintf(stderr, "fuzz: seed %u, number %llu\n", seed, static_cast<unsigned long long>(number)); }

/// Bytes and numbers at which readers change their minds.
constexpr std::uint8_t awkwardBytes[] = {0,  1,  2,   4,   7,   8,   15,  16,  31,  32,
                                         63, 64, 127, 128, 192, 254, 255, '"', '{', '['};
const std::vector<std::string> awkwardTexts{"-1",    "0",     "1",    "2147483647", "4294967296", "1e308",
                                            "1e999", "-0.0",  "null", "true",       "{}",         "[]",
                                            "\"\"",  "[[[[[", ",",    "\\u0000"};

class Damage {
  public:
    Damage(const std::vector<ByteList>& seeds, std::uint32_t firstSeed, std::uint64_t which)
        : random_(firstSeed * 0x9e3779b97f4a7c15ull + which), seeds_(seeds) {}

    ByteList made() {
        ByteList bytes = seeds_[below(seeds_.size())];
        for (std::size_t changes = 1 + below(6); changes > 0; --changes) change(bytes);
        return bytes;
    }

  private:
    std::size_t below(std::size_t count) {
        return static_cast<std::size_t>(random_() % std::max<std::size_t>(count, 1));
    }

    void change(ByteList& bytes) {
        if (bytes.empty()) bytes.push_back(0);
        const std::size_t at = below(bytes.size()), length = 1 + below(std::min<std::size_t>(bytes.size() - at, 64));
        const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
        switch (below(8)) {
        case 0: bytes[at] = static_cast<std::uint8_t>(random_()); break;
        case 1: bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ 1u << below(8)); break;
        case 2: bytes[at] = awkwardBytes[below(std::size(awkwardBytes))]; break;
        case 3: bytes.erase(place, place + static_cast<std::ptrdiff_t>(length)); break;
        case 4: {
            const ByteList copy(place, place + static_cast<std::ptrdiff_t>(length));
            bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size())), copy.begin(), copy.end());
            break;
        }
        case 5: replaceNumber(bytes, at); break;
        case 6: bytes.resize(below(bytes.size() + 1)); break;
        default: {
            const ByteList& other = seeds_[below(seeds_.size())];
            const std::size_t from = below(other.size()), count = below(other.size() - from);
            bytes.insert(place, other.begin() + static_cast<std::ptrdiff_t>(from),
                         other.begin() + static_cast<std::ptrdiff_t>(from + count));
        }
        }
    }

    /// The next number of a text.
    void replaceNumber(ByteList& bytes, std::size_t at) {
        const auto digit = [](std::uint8_t c) { return c >= '0' && c <= '9'; };
        const auto first = std::find_if(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.end(), digit);
        const auto last = std::find_if_not(first, bytes.end(), digit);
        const std::string& text = awkwardTexts[below(awkwardTexts.size())];
        const auto place = bytes.erase(first, last);
        bytes.insert(place, text.begin(), text.end());
    }

    std::mt19937_64 random_;
    const std::vector<ByteList>& seeds_;
};

ByteList contentOf(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return ByteList(std::istreambuf_iterator<char>(stream), {});
}

std::vector<ByteList> corpus(const std::vector<std::string>& extensions) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(CORPUS))
        if (std::find(extensions.begin(), extensions.end(), entry.path().extension()) != extensions.end())
            paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<ByteList> all;
    for (const auto& path : paths) all.push_back(contentOf(path));
    return all;
}

struct Target {
    std::vector<ByteList> seeds;
    std::function<void(const ByteList&)> read;
};

Target targetOf(const std::string& name, const test::TemporaryFolder& folder) {
    if (name == "image")
        return {corpus({".png", ".jpg"}),
                [](const ByteList& bytes) { decodeImage(bytes, {.side = 1024, .bytes = std::size_t{32} << 20}); }};
    if (name == "settings")
        return {corpus({".json"}),
                [](const ByteList& bytes) { settingsOfJson(std::string(bytes.begin(), bytes.end()), "file"); }};
    if (name != "model") throw std::runtime_error("fuzz model|image|settings SECONDS [SEED [FIRST]]");
    test::GltfFile file = test::fileWithEverything();
    const std::string text = file.json.dump();
    return {{file.glb(), ByteList(text.begin(), text.end())}, [&folder](const ByteList& bytes) {
                const auto scene = loadGltf(folder.write("m.gltf", bytes), {.memoryLimit = std::uint64_t{64} << 20});
                scene->motionMesh(0.1, 0.2);
            }};
}

void runTarget(const Target& target, double seconds) {
    const auto begin = std::chrono::steady_clock::now();
    const std::uint64_t first = number;
    std::uint64_t refused = 0;
    for (;; ++number) {
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
        if (number > first && spent.count() > seconds) break;
        try {
            target.read(Damage(target.seeds, seed, number).made());
        } catch (const Error& error) {
            ++refused;
            if (std::string(error.what()).find('\n') != std::string::npos) throw std::runtime_error(error.what());
        }
    }
    std::printf("%llu inputs, %llu refused\n", static_cast<unsigned long long>(number - first),
                static_cast<unsigned long long>(refused));
}

}  // namespace

int main(int argumentCount, char** arguments) {
#if defined(__SANITIZE_ADDRESS__)
    __sanitizer_set_death_callback(sayWhere);
#endif
    try {
        const test::TemporaryFolder folder;
        const Target target = targetOf(argumentCount > 1 ? arguments[1] : "", folder);
        if (argumentCount > 3) seed = static_cast<std::uint32_t>(std::strtoul(arguments[3], nullptr, 10));
        if (argumentCount > 4) number = std::strtoull(arguments[4], nullptr, 10);
        runTarget(target, argumentCount > 2 ? std::atof(arguments[2]) : 10.0);
        return 0;
    } catch (const std::exception& error) {
        sayWhere();
        std::fprintf(stderr, "fuzz: %s\n", error.what());
        return 1;
    }
}
