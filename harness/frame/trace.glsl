/* What an invocation reads, as the words of profile/trace.h, into its own slots. The head comes from the host: with no
 * slots, or no room for fragments, all is counted and nothing is written. */
layout(std430, BIND_STORAGE) buffer AobTrace {
    uint row, slots, room; /* the first row that is drawn; words of an invocation; fragments that fit */
    uint most, count;      /* words that any invocation has; fragments */
    uint spare[3];
    uint words[];
} aob_trace;
uint aob_slot = 0u, aob_slots = 0u, aob_at = 0u;
void aob_note(uint word) {
    if (aob_slot < aob_slots)
        aob_trace.words[aob_at + aob_slot] = word;
    aob_slot++;
}
void aob_close() {
    atomicMax(aob_trace.most, aob_slot);
    for (; aob_slot < aob_slots; aob_slot++)
        aob_trace.words[aob_at + aob_slot] = AOB_TRACE_NONE;
}
/* The texel to the upper left of a bilinear sample: -1 beyond the first one, of which the sampler makes the first. */
ivec2 aob_upper_left(vec2 uv, ivec2 size) {
    return ivec2(clamp(floor(uv * vec2(size) - 0.5), vec2(-1.0), vec2(size - 1)));
}
uint aob_footprint(ivec2 upper_left) {
    return AOB_TRACE_BILINEAR | (upper_left.x < 0 ? AOB_TRACE_ONE_COLUMN : 0u) |
           (upper_left.y < 0 ? AOB_TRACE_ONE_ROW : 0u);
}
#define discard do { aob_close(); discard; } while (false)
