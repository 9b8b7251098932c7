#include "scene/gltf_files.h"

#include <algorithm>
#include <fstream>
#include <string_view>

#include <fmt/format.h>

#include "core/error.h"
#include "core/one_line.h"

namespace timeshade::gltf {

namespace {

namespace fs = std::filesystem;

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::string percentDecoded(std::string_view uri) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const int high = uri[i] == '%' && i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
        const int low = high >= 0 ? hexDigit(uri[i + 2]) : -1;
        if (low >= 0) {
            text.push_back(static_cast<char>(high * 16 + low));
            i += 2;
        } else {
            text.push_back(uri[i]);
        }
    }
    return text;
}

int base64Digit(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+' || c == '-') return 62;
    if (c == '/' || c == '_') return 63;
    return -1;
}

Bytes decodeDataUri(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64"))
        throw Error("a data URI is not base64");
    Bytes bytes;
    bytes.reserve((uri.size() - comma) / 4 * 3);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : uri.substr(comma + 1)) {
        if (c == '=') break;
        const int digit = base64Digit(c);
        if (digit < 0) throw Error("a data URI holds a character that is not base64");
        bits = (bits << 6) | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<std::uint8_t>((bits >> count) & 0xffu));
        }
    }
    return bytes;
}

bool inside(const fs::path& folder, const fs::path& file) {
    const auto [rest, ignored] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    return rest == folder.end();
}

/// RFC 3986: a letter, then letters, digits, plus, hyphen and full stop up to a colon, which precedes any slash. Tested
/// before percent-decoding: an encoded colon belongs to a name.
bool hasScheme(std::string_view uri) {
    const std::size_t colon = uri.find_first_of(":/?#");
    if (colon == std::string_view::npos || uri[colon] != ':' || colon == 0) return false;
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    return letter(uri[0]) && std::all_of(uri.begin(), uri.begin() + static_cast<std::ptrdiff_t>(colon), [&](char c) {
               return letter(c) || (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
           });
}

/// Whether a file name is a hash, as caches name what they hold: at least eight hexadecimal digits, letters as well as
/// numerals (a date is none), maybe after the name of the hash ("sha256-", "SHA256E-s840--") and before endings. People
/// name no file so.
bool isContentAddress(std::string_view name) {
    name = name.substr(0, name.find('.'));
    const std::size_t dash = name.rfind('-');
    if (dash != std::string_view::npos) {
        const std::string_view hash = name.substr(0, 3);
        if (hash != "sha" && hash != "SHA" && hash != "md5" && hash != "MD5") return false;
        name = name.substr(dash + 1);
    }
    const auto numerals = std::count_if(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
    const auto digits = std::count_if(name.begin(), name.end(), [](char c) { return hexDigit(c) >= 0; });
    const auto length = static_cast<std::ptrdiff_t>(name.size());
    return length >= 8 && digits == length && numerals > 0 && numerals < length;
}

}  // namespace

Bytes readRegularFile(const fs::path& path, std::size_t limit, MemoryBudget& memory) {
    std::error_code failure;
    const fs::file_status status = fs::status(path, failure);
    if (!fs::exists(status)) throw Error("there is no such file");
    if (fs::is_directory(status)) throw Error("is a folder, not a file");
    if (!fs::is_regular_file(status)) throw Error("is not a regular file");
    const std::uintmax_t size = fs::file_size(path, failure);
    if (failure) throw Error("its size cannot be read: " + failure.message());
    if (size > limit) throw Error(fmt::format("has {} bytes, the limit is {}", size, limit));
    memory.take(1, size, "the bytes of " + oneLine(path.filename().string(), 50));

    std::ifstream file(path, std::ios::binary);
    if (!file) throw Error("cannot be opened for reading");
    Bytes bytes(static_cast<std::size_t>(size));
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (static_cast<std::size_t>(file.gcount()) != bytes.size()) throw Error("could not be read to its end");
    return bytes;
}

fs::path FilesBeside::resolve(const std::string& uri) const {
    const std::string text = percentDecoded(uri);
    // Dot segments are resolved as text, before any link is followed.
    const fs::path relative = fs::path(text).lexically_normal();
    if (text.empty() || hasScheme(uri) || relative.is_absolute() || *relative.begin() == ".." ||
        text.find_first_of(std::string_view("\\\0", 2)) != std::string::npos)
        throw Error("only files inside the model's folder may be referred to");

    std::error_code failure;
    const fs::path folder = fs::canonical(folder_.empty() ? fs::path(".") : folder_, failure);
    if (failure) throw Error("the model's folder cannot be read: " + failure.message());
    const fs::path file = fs::canonical(folder / relative, failure);
    if (failure) throw Error("there is no such file");
    if (inside(folder, file)) return file;
    // A file that is itself a link, in a folder that is none.
    const fs::path parent = fs::canonical((folder / relative).parent_path(), failure);
    if (!failure && inside(folder, parent) && isContentAddress(file.filename().string())) return file;
    throw Error(
        "only files inside the model's folder may be referred to, and links to files that are named by their content");
}

std::shared_ptr<const Bytes> FilesBeside::read(const std::string& uri) {
    try {
        if (uri.starts_with("data:")) {
            if (uri.size() / 4 * 3 > left_) throw Error("exceeds the limit on bytes of buffers");
            memory_->take(1, uri.size() / 4 * 3, "the bytes of data URIs");
            auto bytes = std::make_shared<const Bytes>(decodeDataUri(uri));
            left_ -= std::min(left_, bytes->size());
            return bytes;
        }
        const fs::path file = resolve(uri);
        if (const auto found = known_.find(file); found != known_.end()) return found->second;
        auto bytes = std::make_shared<const Bytes>(readRegularFile(file, left_, *memory_));
        left_ -= bytes->size();
        known_.emplace(file, bytes);
        return bytes;
    } catch (const Error& error) {
        throw Error(fmt::format("\"{}\": {}", oneLine(uri, 50), error.what()));
    }
}

Sha256 FilesBeside::digest() const {
    Bytes names;
    for (const auto& [path, bytes] : known_) {
        const std::string name = path.filename().string();
        names.insert(names.end(), name.begin(), name.end());
        const Sha256 content = sha256(*bytes);
        names.insert(names.end(), content.begin(), content.end());
    }
    return sha256(names);
}

}  // namespace timeshade::gltf
