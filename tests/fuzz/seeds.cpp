// Writes the models that fuzzing begins with into a folder: fuzz_seeds FOLDER.
#include <cstddef>
#include <filesystem>
#include <string>

#include "../broken_gltf/gltf_writer.h"

namespace {

using namespace timeshade::test;

std::string base64(const ByteList& bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63u] : '=';
    }
    return text;
}

void write(const std::filesystem::path& path, const ByteList& bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

int main(int argumentCount, char** arguments) {
    if (argumentCount != 2) return 2;
    const std::filesystem::path folder = arguments[1];
    const GltfFile file = fileWithEverything();
    write(folder / "everything.glb", file.glb());
    Json whole = file.json;
    whole["buffers"] = Json::array(
        {{{"byteLength", file.data.size()}, {"uri", "data:application/octet-stream;base64," + base64(file.data)}}});
    const std::string text = whole.dump();
    write(folder / "everything.gltf", ByteList(text.begin(), text.end()));
    return 0;
}
