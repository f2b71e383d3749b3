/* What an invocation reads, as numbers of texels, into its own slots. The head comes from the host: with no slots, or no
 * room for fragments, all is counted and nothing is written. */
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
        aob_trace.words[aob_at + aob_slot] = 0xffffffffu;
}
/* The texel to the upper left of a bilinear sample; the footprint ends at the texture's edge, as the sampler's does. */
ivec2 aob_footprint(vec2 uv, ivec2 size) {
    return clamp(ivec2(floor(uv * vec2(size) - 0.5)), ivec2(0), size - 1);
}
#define discard do { aob_close(); discard; } while (false)
