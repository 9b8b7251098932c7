// The partition of a part of the shutter into what one place of the image sees: triangles are put into it one after
// another, and of what is seen at the same time the nearest stays.
#include "lib/seen_changes.glsl"

#define SEGMENTS_TOGETHER 24
#define STATIC_TRIANGLE 0xffffffffu  // in place of a seen triangle's number: what is static

vec2 place;      // in the image
uint staticId;   // what is static there
float staticDistance;
const float farAway = 3e38;

// Of [from, to], in ticks. Two partitions, of which one is made from the other.
float from, to;
uint numbers[2 * SEGMENTS_TOGETHER];
float ends[2 * SEGMENTS_TOGETHER];
vec2 depths[2 * SEGMENTS_TOGETHER];  // the least and the greatest of the triangle
int first = 0;                       // of the one that holds
int segments;
bool isFull = false;  // something found no room: the partition is of no use

// What the ray meets of a triangle's plane at u: edge functions, their sum, and the depth. The same arithmetic as the
// sample pass.
struct Met {
    vec3 edges;
    float sum, depth;
};

Met metAt(ViewPath p, float u) {
    vec3 v0 = mix(p.open0, p.close0, u), v1 = mix(p.open1, p.close1, u), v2 = mix(p.open2, p.close2, u);
    vec3 ray = rayAt(place, u);  // of z 1 unless the view turns
    precise vec3 e =
        edgeFunctions(v0.xy * ray.z - ray.xy * v0.z, v1.xy * ray.z - ray.xy * v1.z, v2.xy * ray.z - ray.xy * v2.z);
    float sum = e.x + e.y + e.z;
    return Met(e, sum, dot(e, vec3(v0.z, v1.z, v2.z)) / sum / ray.z);
}

bool isSeenAt(SeenTriangle t, float u) {
    Met m = metAt(t.path, u);
    bool front = min(min(m.edges.x, m.edges.y), m.edges.z) >= 0.0 && m.sum > 0.0;
    bool back = max(max(m.edges.x, m.edges.y), m.edges.z) <= 0.0 && m.sum < 0.0 && t.doubleSided;
    return (front || back) && m.depth > cameraView.nearDistance;
}

// Of a triangle that is known to be seen around u: whatever the edges' signs, which rounding may turn.
float depthAt(ViewPath p, float u) { return metAt(p, u).depth; }

float tickOf(float u) { return floor(u * TICKS + 0.5); }

int newFirst, newSegments;

void append(uint number, float end, vec2 depth) {
    int last = newFirst + newSegments - 1;
    if (newSegments > 0 && numbers[last] == number) {
        ends[last] = end;
    } else if (newSegments == SEGMENTS_TOGETHER) {
        isFull = true;
    } else {
        numbers[last + 1] = number;
        ends[last + 1] = end;
        depths[last + 1] = depth;
        ++newSegments;
    }
}

// A triangle that is put in.
struct Seen {
    uint number, id;
    SeenTriangle triangle;
    vec2 depth;  // the least and the greatest
};

bool isNearer(Seen mine, ViewPath other, uint otherId, bool isStatic, float u) {
    float depth = depthAt(mine.triangle.path, u), otherDepth = isStatic ? staticDistance : depthAt(other, u);
    // Of two that coincide the first of the mesh is seen, as in the sample pass.
    return depth < otherDepth || (depth == otherDepth && mine.id < otherId);
}

// Where the order changes between ticks x and y, if it does so once, by halving; y where both ends have one order.
float orderChangeBetween(Seen mine, ViewPath other, uint otherId, bool isStatic, float x, float y) {
    float low = x, high = y;
    bool atLow = isNearer(mine, other, otherId, isStatic, low / TICKS);
    ONLY_IF(atLow != isNearer(mine, other, otherId, isStatic, high / TICKS)) {
        while (high - low > 1.0) {
            float middle = floor(0.5 * (low + high));
            if (isNearer(mine, other, otherId, isStatic, middle / TICKS) == atLow)
                low = middle;
            else
                high = middle;
        }
    }
    return high;
}

// Appends the part from x to y of a segment whose depths overlap those of the triangle: whichever is nearer.
void appendNearer(Seen mine, uint number, vec2 depth, float x, float y) {
    bool isStatic = number == STATIC_TRIANGLE;
    uint otherId = staticId;
    ViewPath other = mine.triangle.path;
    ONLY_IF(!isStatic) {
        otherId = texelFetch(seenTriangleIds, int(number)).x;
        other = seenTriangle(number).path;
    }
    OrderChanges changes =
        orderChanges(place, mine.triangle.path, other, isStatic, staticDistance, isStatic || mine.number < number,
                     x / TICKS, y / TICKS);
    float u = 0.0, unseen = y;
    // What the polynomial leaves in doubt, the depths may tell.
    ONLY_IF(nextChange(changes, x / TICKS) * TICKS >= y) {
        unseen = orderChangeBetween(mine, other, otherId, isStatic, x, y);
    }
    for (float at = x; at < y;) {
        u = nextChange(changes, u);
        float next = clamp(tickOf(u), x, y);
        if (unseen > at) next = min(next, unseen);
        if (next > at) {
            bool nearer = isNearer(mine, other, otherId, isStatic, 0.5 * (at + next) / TICKS);
            append(nearer ? mine.number : number, next, nearer ? mine.depth : depth);
        }
        at = max(at, next);
    }
}

// Puts a triangle into the partition, where it is seen from tick a to tick b if nothing is nearer.
void insert(Seen mine, float a, float b) {
    newFirst = SEGMENTS_TOGETHER - first;
    newSegments = 0;
    float begin = from;
    for (int k = first; k < first + segments; ++k) {
        float end = ends[k], x = clamp(a, begin, end), y = clamp(b, begin, end);
        uint number = numbers[k];
        vec2 depth = depths[k];
        bool overlaps = x < y && mine.depth.x <= depth.y;  // else it is hidden
        bool isInDoubt = overlaps && mine.depth.y >= depth.x && depth.x < farAway;
        if (overlaps && begin < x) append(number, x, depth);
        if (overlaps && !isInDoubt) append(mine.number, y, mine.depth);
        ONLY_IF(isInDoubt) appendNearer(mine, number, depth, x, y);
        if (!overlaps || y < end) append(number, end, depth);
        begin = end;
    }
    first = newFirst;
    segments = newSegments;
}

// The partition without anything that moves.
void beginPartition() {
    segments = 1;
    numbers[first] = STATIC_TRIANGLE;
    ends[first] = to;
    depths[first] = vec2(staticId == NO_TRIANGLE ? farAway : staticDistance);
    isFull = false;
}

// Those of a list, in its order.
void insertCandidates(ivec2 span, vec2 inTile) {
    for (int i = span.x; i < span.y && !isFull; ++i) {
        uvec2 candidate = texelFetch(tileCandidates, i).xy;
        ONLY_IF(isWithin(candidate.y, inTile)) {
            SeenTriangle t = seenTriangle(candidate.x);
            ONLY_IF(maybeSeen(place, t, from / TICKS, to / TICKS)) {
                Seen seen = Seen(candidate.x, texelFetch(seenTriangleIds, int(candidate.x)).x, t, depthsOf(t.path));
                EdgeChanges changes = edgeChanges(place, t);
                float u = 0.0;
                for (float at = from; at < to;) {
                    u = nextChange(changes, u);
                    float next = clamp(tickOf(u), from, to);
                    ONLY_IF(next > at && isSeenAt(t, 0.5 * (at + next) / TICKS)) {
                        insert(seen, at, next);
                    }
                    at = max(at, next);
                }
            }
        }
    }
}
