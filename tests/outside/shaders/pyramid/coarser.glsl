/* The nearest of four; a level with an odd side repeats its last row or column. */
void main()
{
    ivec2 p = 2 * aob_pixel;
    depth = min(min(aob_fetch_finer(p), aob_fetch_finer(p + ivec2(1, 0))),
                min(aob_fetch_finer(p + ivec2(0, 1)), aob_fetch_finer(p + ivec2(1, 1))));
}
