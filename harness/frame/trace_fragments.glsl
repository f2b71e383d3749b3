/* Fragments come in any order, each with its place and its triangle, by which the host orders them. */
void aob_open() {
    uvec2 p = uvec2(gl_FragCoord.xy);
    uint number = atomicAdd(aob_trace.count, 1u);
    if (number < aob_trace.room) {
        aob_slots = aob_trace.slots;
        aob_at = number * (aob_slots + 2u);
        aob_trace.words[aob_at] = p.x | p.y << 16;
        aob_trace.words[aob_at + 1u] = aob_primitive;
        aob_at += 2u;
    }
}
