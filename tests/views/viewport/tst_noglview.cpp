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
