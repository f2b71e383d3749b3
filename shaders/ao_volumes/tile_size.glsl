/* Pixels of the occlusion's size along a side of a tile. */
const int TILE = 8;
