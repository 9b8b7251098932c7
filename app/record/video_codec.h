#pragma once

namespace timeshade {

enum class VideoCodec { H264, Hevc, Av1 };

}  // namespace timeshade
