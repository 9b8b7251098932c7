#include "frame/settings_block.h"

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/hash.h"
#include "shared/frame_blocks.shared.h"

namespace timeshade {

namespace {

const char* glslType(const Setting& setting) {
    if (setting.isSwitch()) return "bool";
    return setting.isWhole() ? "int" : "float";
}

/// Every scalar of a std140 block takes four bytes, one behind the other.
std::uint32_t wordOf(const Setting& setting) {
    const double value = setting.get();
    if (!setting.isWhole()) return std::bit_cast<std::uint32_t>(static_cast<float>(value));
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(value));
}

}  // namespace

void SettingsBlock::set(Technique& technique) {
    Hash key;
    key.add(technique.description().name);
    std::vector<std::uint32_t> words;
    std::string members;
    for (const Setting& setting : settingsOf(technique)) {
        members += std::string(members.empty() ? "" : " ") + glslType(setting) + " " + setting.key + ";";
        words.push_back(wordOf(setting));
        key.add(std::bit_cast<std::uint64_t>(setting.get()));
    }
    key_ = key.value() | 1;
    if (members.empty()) members = "float none;";
    define_.second = members;
    words.resize((words.size() + 4) / 4 * 4);  // a block is a multiple of 16 bytes
    const std::span<const std::uint32_t> data(words);
    if (!buffer_ || buffer_->bytes() != data.size_bytes())
        buffer_.emplace("technique settings", data);
    else
        buffer_->upload(data);
}

void SettingsBlock::bind() const { glBindBufferBase(GL_UNIFORM_BUFFER, TECHNIQUE_SETTINGS_BINDING, buffer_->name()); }

}  // namespace timeshade
