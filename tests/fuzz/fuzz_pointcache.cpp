// SPDX-License-Identifier: GPL-3.0-or-later
// PC2 and MDD files. Input: a byte that says which, and how many vertices the base mesh has; the file.
#include "model/io/pointcache.h"
#include "tests/fuzz/require.h"
#include "tests/support/scarcity.h"

#include <cmath>
#include <cstdio>
#include <memory>

#include <QTemporaryDir>

using namespace model;
using namespace model::io;

namespace {

std::unique_ptr<QTemporaryDir> folder;

QString write(const QString &name, const char *data, std::size_t size)
{
    const QString path = folder->filePath(name);
    std::FILE *file = std::fopen(qPrintable(path), "wb");
    SANDREEL_REQUIRE(file && std::fwrite(data, 1, size, file) == size);
    std::fclose(file);
    return path;
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    folder = std::make_unique<QTemporaryDir>();
    for (int vertices = 1; vertices <= 8; ++vertices) {
        QByteArray text;
        for (int v = 0; v < vertices; ++v)
            text += "v 0 0 0\n";
        write(QString("base%1.obj").arg(vertices), text.constData(), std::size_t(text.size()));
    }
    std::atexit([] { folder.reset(); });
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size < 1)
        return 0;
    const QString path =
        write(data[0] % 2 ? "cache.mdd" : "cache.pc2", reinterpret_cast<const char *>(data + 1), size - 1);
    const QString base = folder->filePath(QString("base%1.obj").arg(data[0] / 2 % 8 + 1));
    tests::AllocationMeter meter;
    const auto sequence = readPointCache(path, base, 0, "cache", Progress());
    SANDREEL_REQUIRE(meter.peak() <= (std::uint64_t(16) << 20) + 64 * size);
    if (!sequence)
        return 0;
    SANDREEL_REQUIRE(std::isfinite((*sequence)->frameRate()) && (*sequence)->frameRate() > 0);
    for (std::uint32_t f = 0; f < (*sequence)->frameCount(); ++f)
        for (const Vec3f &p : (*sequence)->frame(f))
            SANDREEL_REQUIRE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    return 0;
}
