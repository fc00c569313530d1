// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/codec/container/hostilefile.h"
#include "tests/support/scarcity.h"

#include <QDir>
#include <QFile>
#include <QTest>

#include <cmath>

using namespace model;
using namespace model::codec;

namespace tests {

namespace {

const QString DataFolder = QStringLiteral(SANDREEL_SOURCE "/tests/data/");

} // namespace

Bytes dataFile(const QString &path)
{
    QFile file(DataFolder + path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray raw = file.readAll();
    return {raw.begin(), raw.end()};
}

QStringList animFilesIn(const QString &folder)
{
    return QDir(DataFolder + folder).entryList({"*.anim"}, QDir::Files, QDir::Name);
}

void addGoldenRows()
{
    QTest::addColumn<QString>("name");
    for (const QString &name : animFilesIn("anim"))
        QTest::newRow(qPrintable(name)) << name;
    QVERIFY(!animFilesIn("anim").isEmpty());
}

QString complaintAbout(const Bytes &file, const DecodeLimits &limits)
{
    AllocationMeter meter;
    QString complaint;
    const auto decoded = decodeAnimation(Bytes(file), Progress(), limits);
    if (!decoded) {
        const Error &error = decoded.error();
        if (error.offset == Error::None || error.offset > file.size())
            complaint = QString("error %1 has no place in the file").arg(int(error.code));
    } else {
        const DecodedAnimation &animation = **decoded;
        for (const std::uint32_t frame : {0u, animation.frameCount() / 2, animation.frameCount() - 1})
            for (const Vec3f &p : animation.frame(frame))
                if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
                    complaint = QString("frame %1 is not finite").arg(frame);
        if (const auto rest = animation.check(Progress()); !rest && rest.error().code != ErrorCode::CorruptStream)
            complaint = QString("check: error %1").arg(int(rest.error().code));
    }
    if (const std::uint64_t limit = limits.bytesFor(file.size()); meter.peak() > limit)
        complaint = QString("%1 bytes of memory, %2 allowed").arg(meter.peak()).arg(limit);
    return complaint;
}

void checkHostile(const Bytes &file, const QString &what, const DecodeLimits &limits)
{
    const QString complaint = complaintAbout(file, limits);
    QVERIFY2(complaint.isEmpty(), qPrintable(what + ": " + complaint));
}

ErrorCode codeOf(const Bytes &file, const DecodeLimits &limits)
{
    const auto decoded = decodeAnimation(Bytes(file), Progress(), limits);
    return decoded ? NotAnError : decoded.error().code;
}

} // namespace tests
