// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/animationcodec.h"
#include "model/codec/connectivity/codedorder.h"
#include "tests/model/codec/animations.h"
#include "tests/support/testmain.h"

using namespace model;
using namespace model::codec;

class TestCodedOrder final : public QObject
{
    Q_OBJECT

private slots:
    void findsWhatTheEncoderDid()
    {
        for (const auto &[name, animation] : tests::animationTable()) {
            const auto encoded = encodeAnimation(*animation, {ReelSettings{0.05, 0}});
            QVERIFY(encoded.has_value());
            const auto decoded = *decodeAnimation(encoded->bytes);
            const auto order = codedOrder(animation->connectivity(), decoded->connectivity());
            QVERIFY(order.has_value());
            if (animation->connectivity() == decoded->connectivity())
                QVERIFY2(order->empty(), name.c_str());
            else
                QVERIFY2(*order == encoded->permutation, name.c_str());
        }
    }

    void otherMeshesHaveNone()
    {
        const Connectivity strip{9, tests::strip(9)};
        Connectivity turned = strip;
        std::swap(turned.triangles[2], turned.triangles[3]); // the same mesh, but not as the codec writes it
        QVERIFY(codedOrder(strip, turned)->empty());
        QVERIFY(codedOrder(strip, {9, tests::strip(8)})->empty());
        QVERIFY(codedOrder(strip, {10, tests::strip(9)})->empty());
        QVERIFY(codedOrder(strip, strip)->empty());
    }

    void cancels()
    {
        const Progress progress;
        progress.cancel();
        const Connectivity strip{9000, tests::strip(9000)};
        Connectivity other = strip;
        std::swap(other.triangles[2], other.triangles[3]);
        const auto order = codedOrder(strip, other, progress);
        QVERIFY(!order && order.error().code == ErrorCode::Cancelled);
    }
};

SANDREEL_TEST(TestCodedOrder)
#include "tst_codedorder.moc"
