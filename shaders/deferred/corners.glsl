/* The corner itself. An image position times the distance is linear in the view-space point, which lets the rasteriser cut
 * what passes the eye. */
vec4 place(int triangle, int vertex)
{
    vec3 corner = aob_corner(triangle, vertex);
    vec2 centre = aob_project(vec3(0.0, 0.0, -1.0)), pixels = aob_project(vec3(1.0, 1.0, -1.0)) - centre;
    float away = AOB_PERSPECTIVE == 1 ? -corner.z : 1.0;
    vec2 q = corner.xy * pixels + centre * away;
    return vec4(2.0 * q / vec2(aob_target_size) - away, 0.5 * away, away);
}
