void aob_open() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    aob_slots = aob_trace.slots;
    aob_at = ((uint(p.y) - aob_trace.row) * uint(aob_target_size.x) + uint(p.x)) * aob_slots;
}
