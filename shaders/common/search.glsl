/* Outside the image there is nothing to find, and what is near to the eye projects to thousands of pixels: a search that goes
 * on there spends its samples on nothing (docs/decisions/0040). */

/* Share of the way from image position `start` to `end` up to where it leaves the image, 0 to 1. */
float share_in_image(vec2 start, vec2 end)
{
    vec2 way = end - start, room = mix(start, vec2(aob_size) - start, greaterThan(way, vec2(0.0)));
    vec2 share = room / max(abs(way), 1e-3); /* below 0 where the start of a divided image lies beside the depth's */
    return clamp(min(share.x, share.y), 0.0, 1.0);
}

/* Share of the way in space from `position`, which the image shows, to `end` up to where it leaves what the image can show, 0
 * to 1: an image position times the distance before the eye's plane is linear in the place. */
float share_in_view(vec3 position, vec3 end)
{
    float before = 1.0;
    vec2 near = vec2(1.0);
#if AOB_PERSPECTIVE
    if (end.z > 1e-3 * position.z) /* the eye's plane */
        before = 0.999 * position.z / (position.z - end.z);
    end = mix(position, end, before);
    near = -vec2(position.z, end.z);
#endif
    vec2 here = aob_project(position) * near.x, there = aob_project(end) * near.y, size = vec2(aob_size);
    vec4 room = vec4(here, size * near.x - here), left = vec4(there, size * near.y - there);
    vec4 share = room / max(max(room, room - left), 1e-20);
    return before * clamp(min(min(share.x, share.y), min(share.z, share.w)), 0.0, 1.0);
}
