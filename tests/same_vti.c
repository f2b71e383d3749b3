/* same_vti FILE.vti ARRAY FILE.exr CHANNEL: exit code 0 if the array has the channel's bits in each pixel. VTK's file is read
 * from its format's description, without VTK: zlib, appended raw, 64-bit headers. For the tests in cli/. */
#include "exr_reader.h"

static const char *after(const char *text, const char *word)
{
    const char *at = text ? strstr(text, word) : NULL;
    exr_need(at != NULL, word);
    return at + strlen(word);
}

static unsigned char *read_file(const char *path)
{
    FILE *stream = fopen(path, "rb");
    exr_need(stream && fseek(stream, 0, SEEK_END) == 0, "cannot open the .vti");
    size_t size = (size_t)ftell(stream);
    unsigned char *bytes = calloc(size + 1, 1);
    rewind(stream);
    exr_need(fread(bytes, 1, size, stream) == size, "cannot read the .vti");
    fclose(stream);
    return bytes;
}

static uint64_t word_at(const unsigned char *at, size_t index)
{
    uint64_t word;
    memcpy(&word, at + 8 * index, 8);
    return word;
}

/* Number of blocks, bytes of each but the last and of the last, bytes of each as packed; then the blocks. */
static float *unpack(const unsigned char *at, size_t bytes)
{
    uint64_t blocks = word_at(at, 0), size = word_at(at, 1);
    const unsigned char *packed = at + 8 * (3 + blocks);
    unsigned char *pixels = malloc(bytes);
    size_t done = 0;
    for (uint64_t b = 0; b < blocks; b++) {
        uLongf got = bytes - done < size ? bytes - done : size;
        exr_need(uncompress(pixels + done, &got, packed, word_at(at, 3 + b)) == Z_OK, "a damaged block");
        packed += word_at(at, 3 + b);
        done += got;
    }
    exr_need(done == bytes, "an array of another size");
    return (float *)(void *)pixels;
}

int main(int argc, char **argv)
{
    exr_need(argc == 5, "usage: same_vti FILE.vti ARRAY FILE.exr CHANNEL");
    struct exr_file image = exr_read(argv[3]);
    const float *channel = exr_channel(&image, argv[4]);
    unsigned char *vti = read_file(argv[1]);
    char name[128], extent[64];
    exr_need(channel != NULL, argv[4]);
    snprintf(name, sizeof name, "Name=\"%s\"", argv[2]);
    snprintf(extent, sizeof extent, "WholeExtent=\"0 %d 0 %d 0 0\"", image.width - 1, image.height - 1);
    after((const char *)vti, extent);
    long offset = atol(after(after((const char *)vti, name), "offset=\""));
    const char *start = after(after((const char *)vti, "<AppendedData encoding=\"raw\">"), "_");
    size_t row = (size_t)image.width, rows = (size_t)image.height, differ = 0;
    float *pixels = unpack((const unsigned char *)start + offset, 4 * row * rows);
    for (size_t y = 0; y < rows; y++) /* VTK's row 0 is at the bottom */
        differ += memcmp(pixels + (rows - 1 - y) * row, channel + y * row, 4 * row) != 0;
    printf("%zu of %zu rows differ\n", differ, rows);
    free(pixels);
    free(vti);
    exr_free(&image);
    return differ != 0;
}
