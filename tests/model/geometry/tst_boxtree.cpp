// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/geometry/boxtree.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <numeric>
#include <random>

using namespace model;

namespace {

std::vector<Vec3f> somePoints(std::uint32_t count)
{
    std::mt19937 random(count);
    std::vector<Vec3f> points(count);
    for (Vec3f &p : points)
        p = {float(random() % 100), float(random() % 7), float(random() % 3)}; // many equal ones
    return points;
}

} // namespace

class TestBoxTree final : public QObject
{
    Q_OBJECT

private slots:
    void everyItemIsInOneLeaf_data()
    {
        QTest::addColumn<quint32>("count");
        for (const quint32 count : {1u, 2u, 4u, 5u, 1000u})
            QTest::newRow(qPrintable(QString::number(count))) << count;
    }
    void everyItemIsInOneLeaf()
    {
        QFETCH(quint32, count);
        constexpr std::uint32_t LeafSize = 4;
        const BoxTree tree = makeBoxTree(somePoints(count), LeafSize);
        std::vector<std::uint32_t> sorted = tree.order;
        std::ranges::sort(sorted);
        std::vector<std::uint32_t> all(count);
        std::iota(all.begin(), all.end(), 0u);
        QVERIFY(sorted == all);

        QCOMPARE(tree.nodes.front().begin, 0u);
        QCOMPARE(tree.nodes.front().end, count);
        std::uint32_t inLeaves = 0;
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
            const BoxTree::Node &node = tree.nodes[i];
            if (node.isLeaf()) {
                QVERIFY(node.size() >= 1 && node.size() <= LeafSize);
                QCOMPARE(node.begin, inLeaves); // from left to right, without a gap
                inLeaves = node.end;
                continue;
            }
            const BoxTree::Node &left = tree.nodes[i + 1], &right = tree.nodes.at(node.right);
            QVERIFY(left.begin == node.begin && left.end == right.begin && right.end == node.end);
            QVERIFY(left.size() + 1 >= right.size() && right.size() <= left.size() + 1);
        }
        QCOMPARE(inLeaves, count);
    }

    void boxesHoldWhatIsBelow()
    {
        const std::vector<Vec3f> points = somePoints(300);
        const BoxTree tree = makeBoxTree(points, 3);
        // Fitted to other places than the tree was made of: as in another frame.
        const auto moved = [&](std::uint32_t i) { return points[i] * 2 + Vec3f{float(i), 0, 1}; };
        const std::vector<Box3f> boxes = fitBoxes(tree, [&](std::uint32_t i) { return Box3f{moved(i), moved(i)}; });
        QCOMPARE(boxes.size(), tree.nodes.size());
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            Box3f expected;
            for (std::uint32_t at = tree.nodes[i].begin; at < tree.nodes[i].end; ++at)
                expected.add(moved(tree.order[at]));
            QVERIFY(boxes[i].min == expected.min && boxes[i].max == expected.max);
        }
    }

    void nothingMakesNoNode() { QVERIFY(makeBoxTree({}, 4).nodes.empty()); }
};

SANDREEL_TEST(TestBoxTree)
#include "tst_boxtree.moc"
