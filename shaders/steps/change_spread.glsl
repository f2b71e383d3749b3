/* What a filter carries from pixel to pixel goes beyond the radius: tiles within SPREAD of one that something has changed near are as it is. */
void main()
{
    float most = 0.0;
    for (int y = -SPREAD; y <= SPREAD; y++)
        for (int x = -SPREAD; x <= SPREAD; x++)
            most = max(most, aob_fetch_near(aob_pixel + ivec2(x, y)));
    changed = most;
}
