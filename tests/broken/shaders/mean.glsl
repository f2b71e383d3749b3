/* Means over time with a fault: one that asks of no surface whether it is the same, nor of a number whether it is one; and one in
 * which the frames of before hardly count. */
#include "fault.glsl"

void main()
{
    AOB_TYPE_NOW now = aob_fetch_now(aob_pixel), before = aob_fetch_before(aob_pixel);
    float share = FAULT == FORGETS_AT_ONCE ? 0.9 : 1.0 / min(float(aob_frame + 1), float(HISTORY));
    mean = aob_frame == 0 ? now : before + share * (now - before);
}
