/* A box along the axes of view space. */
struct box {
    vec3 low, high;
};

/* How far apart two boxes are. */
float gap(box a, box b) { return length(max(max(b.low - a.high, a.low - b.high), vec3(0.0))); }

/* How far apart a point of one and a point of the other can be. */
float farthest(box a, box b) { return length(max(b.high - a.low, a.high - b.low)); }

/* The pixels that the ball of radius r about any point of the box can cover. False where it may reach the eye: then it can be any. */
bool window_of(box b, float r, out ivec2 first, out ivec2 last)
{
    vec2 low = vec2(1e30), high = vec2(-1e30);
    vec3 near = b.low - r, away = b.high + r;
    first = ivec2(0);
    last = aob_size - 1;
    if (AOB_PERSPECTIVE == 1 && away.z > -1e-6)
        return false;
    for (int k = 0; k < 8; k++) {
        vec2 q = aob_project(vec3((k & 1) == 0 ? near.x : away.x, (k & 2) == 0 ? near.y : away.y, (k & 4) == 0 ? near.z : away.z));
        low = min(low, q);
        high = max(high, q);
    }
    first = ivec2(clamp(low, vec2(0.0), vec2(last)));
    last = ivec2(clamp(high, vec2(0.0), vec2(last)));
    return true;
}
