#include "measure/reference_cache.h"

#include "core/file_bytes.h"
#include "core/sha256.h"
#include "measure/user_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstring>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <utility>

namespace timeshade {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "the files hold the machine's own numbers");

// A file: this header, the key, the values of the image, a SHA-256 of all that.
struct Header {
    std::array<char, 8> magic = {'T', 'S', 'H', 'A', 'D', 'R', 'E', 'F'};
    std::uint32_t version = 1;
    std::uint32_t keySize = 0;
    std::uint32_t width = 0;
    std::uint32_t height = 0;

    bool operator==(const Header&) const = default;
};
static_assert(sizeof(Header) == 24 && std::has_unique_object_representations_v<Header>);

constexpr std::size_t nameDigits = 2 * sizeof(Sha256);
constexpr const char* extension = ".reference";
/// A picture of this side is larger than any sensible cache.
constexpr int maximumSide = 1 << 15;

Header headerOf(const std::string& key, int width, int height) {
    Header header;
    header.keySize = static_cast<std::uint32_t>(key.size());
    header.width = static_cast<std::uint32_t>(width);
    header.height = static_cast<std::uint32_t>(height);
    return header;
}

bool isSize(int width, int height) { return width > 0 && height > 0 && width <= maximumSide && height <= maximumSide; }

std::size_t valueCount(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3;
}

Sha256 checksum(const std::vector<unsigned char>& bytes, std::size_t count) { return sha256({bytes.data(), count}); }

std::vector<unsigned char> encode(const std::string& key, const LinearImage& image) {
    const Header header = headerOf(key, image.width, image.height);
    const std::size_t imageSize = image.rgb.size() * sizeof(float);
    const std::size_t hashed = sizeof(Header) + key.size() + imageSize;
    std::vector<unsigned char> bytes(hashed + sizeof(Sha256));
    std::memcpy(bytes.data(), &header, sizeof(Header));
    std::copy(key.begin(), key.end(), bytes.begin() + sizeof(Header));
    std::memcpy(bytes.data() + sizeof(Header) + key.size(), image.rgb.data(), imageSize);
    const Sha256 hash = checksum(bytes, hashed);
    std::memcpy(bytes.data() + hashed, hash.data(), hash.size());
    return bytes;
}

std::optional<LinearImage> decode(const std::vector<unsigned char>& bytes, const std::string& key, int width,
                                  int height) {
    const std::size_t imageStart = sizeof(Header) + key.size();
    const std::size_t hashed = imageStart + valueCount(width, height) * sizeof(float);
    if (bytes.size() != hashed + sizeof(Sha256)) {
        return std::nullopt;
    }
    Header header;
    std::memcpy(&header, bytes.data(), sizeof(Header));
    if (header != headerOf(key, width, height) ||
        !std::equal(key.begin(), key.end(), reinterpret_cast<const char*>(bytes.data()) + sizeof(Header))) {
        return std::nullopt;
    }
    const Sha256 hash = checksum(bytes, hashed);
    if (!std::equal(hash.begin(), hash.end(), bytes.begin() + static_cast<std::ptrdiff_t>(hashed))) {
        return std::nullopt;
    }
    LinearImage image{width, height, std::vector<float>(valueCount(width, height))};
    std::memcpy(image.rgb.data(), bytes.data() + imageStart, hashed - imageStart);
    return image;
}

/// Reads no more than a file that could be right: what lies there may be anything.
std::optional<LinearImage> readChecked(const fs::path& file, const std::string& key, int width, int height) {
    const std::uintmax_t expected =
        sizeof(Header) + key.size() + valueCount(width, height) * sizeof(float) + sizeof(Sha256);
    std::error_code failed;
    if (fs::file_size(file, failed) != expected || failed) {
        return std::nullopt;
    }
    return decode(readFileBytes(file), key, width, height);
}

/// What is measured is nobody else's business. A folder that is there keeps its permissions.
void makePrivateFolder(const fs::path& folder) {
    if (fs::create_directories(folder)) fs::permissions(folder, fs::perms::owner_all);
}

/// One of our images, or what a killed process left of writing one. Nothing else in the folder is ever deleted.
enum class Kind { foreign, image, leftover };

Kind kindOf(const fs::path& file) {
    const std::string name = file.filename().string();
    const bool named = name.size() > nameDigits && name.find_first_not_of("0123456789abcdef") == nameDigits &&
                       name.compare(nameDigits, std::strlen(extension), extension) == 0;
    if (!named) {
        return Kind::foreign;
    }
    if (name.size() == nameDigits + std::strlen(extension)) {
        return Kind::image;
    }
    return file.extension() == ".part" ? Kind::leftover : Kind::foreign;
}

}  // namespace

ReferenceCache::ReferenceCache(fs::path folder, std::uintmax_t maximumBytes)
    : folder_(std::move(folder)), maximumBytes_(maximumBytes) {}

fs::path ReferenceCache::defaultFolder() { return userFolder("XDG_CACHE_HOME", ".cache"); }

fs::path ReferenceCache::fileOf(const std::string& key, int width, int height) const {
    const std::string text = fmt::format("{}x{} {}", width, height, key);
    return folder_ / (toHex(sha256({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()})) + extension);
}

std::optional<LinearImage> ReferenceCache::load(const std::string& key, int width, int height) const {
    if (folder_.empty() || !isSize(width, height)) {
        return std::nullopt;
    }
    try {
        const fs::path file = fileOf(key, width, height);
        std::error_code ignored;
        if (!fs::is_regular_file(file, ignored)) {
            return std::nullopt;
        }
        std::optional<LinearImage> image = readChecked(file, key, width, height);
        if (image) {
            // shrink() goes by this time.
            fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
        } else {
            fs::remove(file, ignored);
        }
        return image;
    } catch (const std::exception&) {
        // Unreadable, or no memory: the caller renders the reference again.
        return std::nullopt;
    }
}

bool ReferenceCache::store(const std::string& key, const LinearImage& image) const {
    if (folder_.empty() || !isSize(image.width, image.height) ||
        image.rgb.size() != valueCount(image.width, image.height)) {
        return false;
    }
    try {
        makePrivateFolder(folder_);
        const fs::path file = fileOf(key, image.width, image.height);
        const std::vector<unsigned char> bytes = encode(key, image);
        writeFileAtomically(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        shrink(file);
        return true;
    } catch (const std::exception&) {
        // No permission, a full disk: the next run renders the reference again.
        return false;
    }
}

void ReferenceCache::shrink(const fs::path& newest) const {
    struct Entry {
        fs::file_time_type used;
        fs::path file;
        std::uintmax_t size;
    };
    std::vector<Entry> entries;
    std::uintmax_t total = 0;
    std::error_code failed;
    const auto anHourAgo = fs::file_time_type::clock::now() - std::chrono::hours(1);
    for (fs::directory_iterator it(folder_, failed), end; !failed && it != end; it.increment(failed)) {
        // Another process may delete files meanwhile: each question may fail by itself.
        std::error_code gone;
        const Kind kind = kindOf(it->path());
        const auto used = it->last_write_time(gone);
        if (kind == Kind::foreign || !it->is_regular_file(gone) || gone) {
            continue;
        }
        const std::uintmax_t size = it->file_size(gone);
        if (kind == Kind::leftover && used < anHourAgo) {
            fs::remove(it->path(), gone);
        } else if (kind == Kind::image && !gone) {
            total += size;
            entries.push_back({used, it->path(), size});
        }
    }
    // Names break ties, so that the order does not depend on the file system.
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return std::tie(a.used, a.file) < std::tie(b.used, b.file); });
    for (const Entry& entry : entries) {
        if (total > maximumBytes_ && entry.file != newest) {
            fs::remove(entry.file, failed);
            total -= failed ? 0 : entry.size;
        }
    }
}

}  // namespace timeshade
