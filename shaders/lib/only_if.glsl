// A branch that is skipped where no lane takes it: a loop of one round. Software renderers run both sides of every `if`
// under a mask, but skip a loop that no lane enters. (A round count that is not known in advance keeps compilers from
// making it an `if` again.)
#define ONLY_IF(condition) for (int rounds = (condition) ? 1 : 0; rounds > 0; --rounds)
