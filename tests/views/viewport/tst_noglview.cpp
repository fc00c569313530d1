// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "views/viewport/noglview.h"

#include <QLabel>

class TestNoGlView final : public QObject
{
    Q_OBJECT

private slots:
    void saysWhatIsMissingAndPlaysAllTheSame()
    {
        views::Player player;
        views::NoGlView view(player);
        view.resize(400, 400);
        view.show();
        QVERIFY(view.findChild<QLabel *>()->text().contains("3.3"));
        QVERIFY(view.picture().isNull());
        player.setPacing(model::Pacing::EveryFrame);
        player.setSource(tests::rigidRotation(tests::cube(), 4));
        QTRY_VERIFY(!view.picture().isNull());
        const QImage first = view.picture();
        QVERIFY(first.pixelColor(first.rect().center()) != first.pixelColor(2, 2));
        player.play();
        QTRY_COMPARE(player.playback().frame(), 2u);
        QTRY_VERIFY(view.picture() != first);
        player.setSource(nullptr);
        QVERIFY(view.picture().isNull());
    }

    /// The left half of a sheet is where it was, the right half is off; from frame to frame by more.
    void errorsAreColoured()
    {
        const auto original = tests::constant(tests::grid(), 3);
        std::vector<model::Vec3f> positions(original->allPositions().begin(), original->allPositions().end());
        const std::size_t count = original->vertexCount();
        for (std::size_t i = 0; i < positions.size(); ++i)
            if (positions[i].x > 0.6f)
                positions[i].z += 0.01f * float(i / count + 1);
        views::Player player;
        views::NoGlView view(player);
        view.resize(400, 500);
        view.show();
        player.setSource(std::make_shared<model::Sequence>(original->connectivity(), positions));
        QTRY_VERIFY(!view.picture().isNull());
        const auto side = [&view](double place) {
            const QImage &picture = view.picture();
            return picture.pixelColor(int(place * picture.width()), picture.height() / 2);
        };
        const auto isSand = [](QColor color) { // the surface's own
            return color.red() > color.green() && color.green() > color.blue() && color.blue() > 0.4 * color.red();
        };
        const auto isViolet = [](QColor color) { return color.blue() > color.green() && color.red() > color.green(); };
        const auto isYellow = [](QColor color) {
            return color.green() > 0.85 * color.red() && color.blue() < 0.4 * color.red();
        };
        constexpr double Left = 0.35, Right = 0.65;
        QVERIFY2(isSand(side(Left)) && isSand(side(Right)), qPrintable(side(Right).name()));

        views::Comparison comparison(player);
        view.setComparison(&comparison);
        view.setErrorColored(true);
        comparison.start("grid", [original](const model::Progress &) -> model::Result<views::Original> {
            return views::Original{original, {}};
        });
        QTRY_VERIFY(comparison.result().has_value());
        QTRY_VERIFY2(isViolet(side(Left)), qPrintable(side(Left).name()));
        QVERIFY(!isYellow(side(Right))); // a third of the largest error of all frames
        QVERIFY(qAbs(view.errorRange() - 0.03f) < 1e-6f);
        view.setErrorRangeOfFrame(true);
        QTRY_VERIFY2(isYellow(side(Right)), qPrintable(side(Right).name()));
        QVERIFY(qAbs(view.errorRange() - 0.01f) < 1e-6f);
        const QImage shown = view.grab().toImage();
        view.setErrorColored(false);
        QTRY_VERIFY(isSand(side(Left)));
        QCOMPARE(view.errorRange(), 0.0f);
        const QImage plain = view.grab().toImage();
        // The scale stands beside the surface: what differs there is not the surface's colour.
        int changed = 0;
        for (int y = view.findChild<QLabel *>()->height(); y < plain.height(); ++y)
            for (int x = plain.width() * 3 / 4; x < plain.width(); ++x)
                changed += !isSand(plain.pixelColor(x, y)) && shown.pixel(x, y) != plain.pixel(x, y);
        QVERIFY2(changed > 200, qPrintable(QString::number(changed)));
        comparison.stop();
        view.setErrorColored(true);
        QTRY_VERIFY(!player.currentFrame()->original);
        QTRY_VERIFY(isSand(side(Right)));
    }

    void goesAwayWhileItDraws()
    {
        views::Player player;
        player.setSource(tests::constant(tests::grid(100, 100), 2));
        QTRY_VERIFY(player.currentFrame());
        auto view = std::make_unique<views::NoGlView>(player);
        view->resize(600, 600);
        view->show();
        view.reset();
        QCoreApplication::processEvents();
    }
};

SANDREEL_TEST(TestNoGlView)
#include "tst_noglview.moc"
