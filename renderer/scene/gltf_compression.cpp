#include "scene/gltf_compression.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/one_line.h"

namespace timeshade::gltf {

using Json = nlohmann::json;

bool decodes(std::string_view extension) {
#ifdef TIMESHADE_MESHOPT
    if (extension == "EXT_meshopt_compression") return true;
#endif
#ifdef TIMESHADE_DRACO
    if (extension == "KHR_draco_mesh_compression") return true;
#endif
    return false;
}

bool isFallback(const Json& buffer) {
    const Json::json_pointer place("/extensions/EXT_meshopt_compression/fallback");
    return decodes("EXT_meshopt_compression") && buffer.contains(place) && buffer[place].is_boolean() &&
           buffer[place].get<bool>();
}

std::uint64_t wholeNumber(const Json& object, const char* key, std::uint64_t least, std::uint64_t most,
                          const std::string& what) {
    const auto found = object.is_object() ? object.find(key) : object.end();
    const double value = found != object.end() && found->is_number() ? found->get<double>() : -1.0;
    if (!(value >= static_cast<double>(least) && value <= static_cast<double>(most)) ||
        value != static_cast<double>(static_cast<std::uint64_t>(value)))
        throw Error(fmt::format(
            "{}: {} is {}, expected a whole number from {} to {}", what, key,
            found == object.end() ? "missing" : oneLine(found->dump(-1, ' ', true, Json::error_handler_t::replace), 40),
            least, most));
    return static_cast<std::uint64_t>(value);
}

int addView(Model& model, Bytes bytes, std::uint64_t stride) {
    const std::uint64_t length = bytes.size();
    model.bufferLengths.push_back(length);
    model.buffers.push_back(std::make_shared<const Bytes>(std::move(bytes)));
    model.views.push_back({static_cast<int>(model.buffers.size()) - 1, 0, length, stride});
    return static_cast<int>(model.views.size()) - 1;
}

void decompress(Model& model, const Json& root) {
    decompressViews(model, root);
    decompressPrimitives(model, root);
}

}  // namespace timeshade::gltf
