// Entries of lists, one list per cell (renderer/passes/cell_lists.h). The same call in both passes: while counting it
// returns how many entries of this cell came before, while filling where in the arrays of entries this one belongs.
// Which entry gets which slot of its list depends on the order of execution: readers must not depend on it. A slot may
// be beyond the end of the array (NO_LIST_SLOT): then nothing must be written.
#include "shared/frame_blocks.shared.h"

layout(std430, binding = LIST_CURSORS_BINDING) buffer ListCursors { uint listCursors[]; };

uint listSlot(uint cell) { return atomicAdd(listCursors[cell], 1u); }
