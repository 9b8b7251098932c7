#include "gl/changed_upload.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "core/check.h"
#include "core/parallel.h"
#include "gl/uploads.h"

namespace timeshade::gl {

namespace {

constexpr std::size_t blockBytes = 4096;
/// As many blocks as are worth a thread.
constexpr std::size_t blocksTogether = 128;

}  // namespace

std::size_t uploadChangedBytes(Buffer& buffer, std::span<const std::byte> now, std::span<const std::byte> before) {
    CHECK_EQ(now.size(), before.size());
    CHECK_LE(now.size(), buffer.bytes());
    const std::size_t blocks = (now.size() + blockBytes - 1) / blockBytes;
    const auto endOf = [&](std::size_t block) { return std::min((block + 1) * blockBytes, now.size()); };
    std::vector<char> differs(blocks);
    forEachOf(blocks, blocksTogether, [&](std::size_t block) {
        const std::size_t first = block * blockBytes;
        differs[block] = std::memcmp(&now[first], &before[first], endOf(block) - first) != 0;
    });
    std::size_t uploaded = 0;
    for (auto first = differs.begin(); (first = std::find(first, differs.end(), 1)) != differs.end();) {
        const auto last = std::find(first, differs.end(), 0);
        const std::size_t from = static_cast<std::size_t>(first - differs.begin()) * blockBytes,
                          to = endOf(static_cast<std::size_t>(last - differs.begin()) - 1);
        uploadBytes(buffer.name(), from, now.subspan(from, to - from));
        uploaded += to - from;
        first = last;
    }
    return uploaded;
}

}  // namespace timeshade::gl
