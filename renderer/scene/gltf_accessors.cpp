#include "scene/gltf_accessors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade::gltf {

namespace {

/// glTF is little-endian, as are all supported machines. Offsets may be unaligned in broken files.
template <typename Stored>
Stored load(const std::uint8_t* from) {
    Stored value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

template <typename Stored, typename Number>
Number decoded(Stored value, bool normalized) {
    if constexpr (std::is_integral_v<Stored> && std::is_floating_point_v<Number>) {
        if (normalized)  // the most negative signed value would be slightly below -1
            return std::max(static_cast<Number>(value) / static_cast<Number>(std::numeric_limits<Stored>::max()),
                            Number(-1));
    }
    return static_cast<Number>(value);
}

template <typename Stored, typename Number>
void decodeElements(const std::uint8_t* from, std::size_t count, std::size_t stride, std::size_t components,
                    bool normalized, Number* to) {
    for (std::size_t i = 0; i < count; ++i, from += stride)
        for (std::size_t c = 0; c < components; ++c)
            *to++ = decoded<Stored, Number>(load<Stored>(from + c * sizeof(Stored)), normalized);
}

template <typename Number>
void decodeAs(Component type, const std::uint8_t* from, std::size_t count, std::size_t stride, std::size_t components,
              bool normalized, Number* to) {
    switch (type) {
    case Component::Byte: return decodeElements<std::int8_t>(from, count, stride, components, normalized, to);
    case Component::UnsignedByte: return decodeElements<std::uint8_t>(from, count, stride, components, normalized, to);
    case Component::Short: return decodeElements<std::int16_t>(from, count, stride, components, normalized, to);
    case Component::UnsignedShort:
        return decodeElements<std::uint16_t>(from, count, stride, components, normalized, to);
    case Component::UnsignedInt: return decodeElements<std::uint32_t>(from, count, stride, components, normalized, to);
    case Component::Float:
        if constexpr (std::is_floating_point_v<Number>)
            decodeElements<float>(from, count, stride, components, false, to);
        return;
    }
}

template <typename Number>
std::vector<Number> readElements(const Model& model, const Accessor& accessor, const std::string& what) {
    const auto components = static_cast<std::size_t>(accessor.components);
    const std::size_t size = byteSize(accessor.type) * components;
    model.memory->take(accessor.count, components * sizeof(Number), what);
    std::vector<Number> values(static_cast<std::size_t>(accessor.count) * components);
    if (accessor.view >= 0) {
        const std::uint64_t stride = model.views[static_cast<std::size_t>(accessor.view)].stride;
        decodeAs(accessor.type, bytesOf(model, accessor.view).data() + accessor.offset, accessor.count,
                 stride == 0 ? size : static_cast<std::size_t>(stride), components, accessor.normalized, values.data());
    }
    if (!accessor.sparse || accessor.sparse->count == 0) return values;

    const SparseValues& sparse = *accessor.sparse;
    model.memory->take(sparse.count, sizeof(std::uint32_t), what);
    std::vector<std::uint32_t> places(sparse.count);
    decodeAs(sparse.indexType, bytesOf(model, sparse.indexView).data() + sparse.indexOffset, sparse.count,
             byteSize(sparse.indexType), 1, false, places.data());
    const std::uint8_t* from = bytesOf(model, sparse.valueView).data() + sparse.valueOffset;
    for (std::size_t i = 0; i < places.size(); ++i, from += size) {
        if (places[i] >= accessor.count)
            throw Error(fmt::format("{}: sparse index {} is beyond its {} elements", what, places[i], accessor.count));
        decodeAs(accessor.type, from, 1, size, components, accessor.normalized, values.data() + places[i] * components);
    }
    return values;
}

const Accessor& shaped(const Model& model, int index, int components, const std::string& what) {
    const Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    if (accessor.components != components)
        throw Error(fmt::format("{}: accessor {} has {} components, expected {}", what, index, accessor.components,
                                components));
    return accessor;
}

}  // namespace

std::span<const std::uint8_t> bytesOf(const Model& model, int view) {
    const View& from = model.views[static_cast<std::size_t>(view)];
    return std::span(*model.buffers[static_cast<std::size_t>(from.buffer)]).subspan(from.offset, from.length);
}

std::vector<float> readFloats(const Model& model, int index, int components, Integers integers,
                              const std::string& what) {
    const Accessor& accessor = shaped(model, index, components, what);
    const bool narrow = accessor.type != Component::Float && accessor.type != Component::UnsignedInt;
    const bool allowed = accessor.type == Component::Float || (narrow && integers == Integers::Quantized) ||
                         (narrow && integers == Integers::Normalized && accessor.normalized);
    if (!allowed)
        throw Error(fmt::format("{}: accessor {} has a component type that is not allowed here", what, index));

    std::vector<float> values = readElements<float>(model, accessor, what);
    const auto bad = std::find_if(values.begin(), values.end(), [](float value) { return !std::isfinite(value); });
    if (bad != values.end())
        throw Error(fmt::format("{}: element {} of accessor {} is not finite", what,
                                (bad - values.begin()) / components, index));
    return values;
}

std::vector<std::uint32_t> readUnsigned(const Model& model, int index, int components, bool wide,
                                        const std::string& what) {
    const Accessor& accessor = shaped(model, index, components, what);
    const bool allowed = accessor.type == Component::UnsignedByte || accessor.type == Component::UnsignedShort ||
                         (wide && accessor.type == Component::UnsignedInt);
    if (!allowed || accessor.normalized)
        throw Error(fmt::format("{}: accessor {} has a component type that is not allowed here", what, index));
    return readElements<std::uint32_t>(model, accessor, what);
}

}  // namespace timeshade::gltf
