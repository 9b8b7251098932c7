#include "gl/counted_draw.h"

#include "gl/read_back.h"

namespace timeshade::gl {

std::size_t drawCounted(LateCounts& late, const CountedDraw& counted) {
    if (late.later() && counted.foreseen->known()) {
        const std::size_t room = counted.foreseen->makeRoom(counted.makeRoom);
        counted.draw(room);
        late.expect(counted.counts, 0, room, counted.foreseen);
        return room;
    }
    for (std::size_t wanted = counted.before;;) {
        const std::size_t room = counted.makeRoom(wanted);
        counted.draw(room);
        wanted = readElement<GLuint>(counted.counts);
        counted.foreseen->note(wanted);
        if (wanted <= room) return wanted;
    }
}

}  // namespace timeshade::gl
