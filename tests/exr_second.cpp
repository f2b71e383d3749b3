#include "exr_second.h"
#include <ImathBox.h>
#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfMultiView.h>
#include <ImfOutputFile.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputFile.h>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <vector>

using namespace OPENEXR_IMF_NAMESPACE;

static std::string full_name(const Header &header, int parts, const char *channel)
{
    std::string part = parts > 1 && header.hasName() ? header.name() : "";
    bool whole = part.empty() || std::string(channel).compare(0, part.size() + 1, part + ".") == 0;
    return whole ? channel : part + "." + channel;
}

static bool add_channel(exr_second_image *image, const std::string &name, const IMATH_NAMESPACE::Box2i &data,
                        const IMATH_NAMESPACE::V2i &corner)
{
    size_t width = (size_t)data.max.x - (size_t)data.min.x + 1,
           height = (size_t)data.max.y - (size_t)data.min.y + 1;
    if (image->count == EXR_SECOND_CHANNELS || name.size() >= EXR_SECOND_NAME || width > 1 << 14 ||
        height > 1 << 14 || width * height > image->capacity - image->used)
        return false;
    exr_second_channel *channel = &image->channels[image->count++];
    strcpy(channel->name, name.c_str());
    channel->left = data.min.x - corner.x;
    channel->top = data.min.y - corner.y;
    channel->width = (int)width;
    channel->height = (int)height;
    channel->first = image->used;
    image->used += width * height;
    return true;
}

static bool read_part(exr_second_image *image, MultiPartInputFile &file, int at)
{
    const Header &header = file.header(at);
    if (header.hasType() && isDeepData(header.type()))
        return false;
    IMATH_NAMESPACE::Box2i data = header.dataWindow(), display = file.header(0).displayWindow();
    FrameBuffer frame;
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
        if (c.channel().xSampling != 1 || c.channel().ySampling != 1 ||
            !add_channel(image, full_name(header, file.parts(), c.name()), data, display.min))
            return false;
        const exr_second_channel *to = &image->channels[image->count - 1];
        std::ptrdiff_t origin = (std::ptrdiff_t)data.min.x + (std::ptrdiff_t)data.min.y * to->width;
        frame.insert(c.name(), Slice(FLOAT, (char *)(image->pixels + to->first - origin), sizeof(float),
                                     sizeof(float) * (size_t)to->width));
    }
    InputPart part(file, at);
    part.setFrameBuffer(frame);
    part.readPixels(data.min.y, data.max.y);
    return true;
}

bool exr_second_read(exr_second_image *image, const char *path)
{
    image->count = 0;
    image->used = 0;
    try {
        MultiPartInputFile file(path, 0);
        IMATH_NAMESPACE::Box2i display = file.header(0).displayWindow();
        image->width = display.max.x - display.min.x + 1;
        image->height = display.max.y - display.min.y + 1;
        for (int i = 0; i < file.parts(); i++)
            if (!read_part(image, file, i))
                return false;
        return true;
    } catch (const std::exception &) {
        return false;
    }
}

/* The values of one channel in its own type. */
static std::vector<char> convert(char type, const float *from, size_t count)
{
    size_t size = type == 'h' ? 2 : 4;
    std::vector<char> to(count * size);
    for (size_t i = 0; i < count; i++) {
        half h(from[i]);
        unsigned whole = (unsigned)from[i];
        memcpy(&to[i * size],
               type == 'h'   ? (const void *)&h
               : type == 'u' ? (const void *)&whole
                             : &from[i],
               size);
    }
    return to;
}

static const std::map<std::string, Compression> compressions = {
    {"none", NO_COMPRESSION},  {"RLE", RLE_COMPRESSION},   {"ZIPS", ZIPS_COMPRESSION},
    {"ZIP", ZIP_COMPRESSION},  {"PIZ", PIZ_COMPRESSION},   {"PXR24", PXR24_COMPRESSION},
    {"B44", B44_COMPRESSION},  {"B44A", B44A_COMPRESSION}, {"DWAA", DWAA_COMPRESSION},
    {"DWAB", DWAB_COMPRESSION}};

static Header make_header(const exr_second_desc *desc)
{
    Header header(desc->width, desc->height);
    header.compression() = compressions.at(desc->compression);
    header.lineOrder() = desc->downwards ? DECREASING_Y : INCREASING_Y;
    if (desc->tile)
        header.setTileDescription(
            TileDescription(desc->tile, desc->tile, desc->mipmap ? MIPMAP_LEVELS : ONE_LEVEL));
    if (desc->views[0])
        addMultiView(header, {desc->views[0], desc->views[1]});
    return header;
}

static void write_tiles(const char *path, const Header &header, const FrameBuffer &frame)
{
    TiledOutputFile file(path, header);
    file.setFrameBuffer(frame);
    for (int level = 0; level < file.numLevels(); level++)
        file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
}

bool exr_second_write(const char *path, const exr_second_desc *desc)
{
    try {
        Header header = make_header(desc);
        FrameBuffer frame;
        std::vector<std::vector<char>> planes;
        size_t count = (size_t)desc->width * (size_t)desc->height;
        for (int c = 0; c < 8 && desc->names[c]; c++) {
            int step = desc->sampling && !desc->names[c + 1] ? desc->sampling : 1;
            PixelType type = desc->types[c] == 'h' ? HALF : desc->types[c] == 'u' ? UINT : FLOAT;
            size_t size = type == HALF ? 2 : 4;
            planes.push_back(convert(desc->types[c], desc->pixels[c], count));
            header.channels().insert(desc->names[c], Channel(type, step, step));
            frame.insert(desc->names[c],
                         Slice(type, planes.back().data(), size, size * (size_t)desc->width, step, step));
        }
        if (desc->tile) {
            write_tiles(path, header, frame);
            return true;
        }
        OutputFile file(path, header);
        file.setFrameBuffer(frame);
        file.writePixels(desc->height);
        return true;
    } catch (const std::exception &) {
        remove(path);
        return false;
    }
}

bool exr_second_write_deep(const char *path, int width, int height)
{
    try {
        Header header(width, height);
        header.channels().insert("Z", Channel(FLOAT));
        header.setType(DEEPSCANLINE);
        header.compression() = ZIPS_COMPRESSION;
        std::vector<unsigned> counts((size_t)width * (size_t)height, 1);
        float value = 2;
        std::vector<float *> samples(counts.size(), &value);
        DeepFrameBuffer frame;
        frame.insertSampleCountSlice(
            Slice(UINT, (char *)counts.data(), sizeof(unsigned), sizeof(unsigned) * width));
        frame.insert("Z", DeepSlice(FLOAT, (char *)samples.data(), sizeof(float *), sizeof(float *) * width,
                                    sizeof(float)));
        DeepScanLineOutputFile file(path, header);
        file.setFrameBuffer(frame);
        file.writePixels(height);
        return true;
    } catch (const std::exception &) {
        return false;
    }
}
