// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/editor/windowdriver.h"

#include "app/editor/window/theme.h"
#include "model/animation/sequence.h"
#include "model/codec/animationcodec.h"
#include "model/io/animfile.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QTest>
#include <QTimer>

#include <cmath>

namespace tests {

namespace {

editor::Language &prepared(editor::Language &language)
{
    editor::applyTheme(editor::Theme::Light);
    language.apply(QStringLiteral("en"));
    return language;
}

} // namespace

WindowDriver::WindowDriver()
    : window(prepared(language))
{
    window.resize(1100, 750);
    window.show();
    window.activateWindow();
    if (!QTest::qWaitForWindowExposed(&window))
        QTest::qFail("the window does not show", __FILE__, __LINE__);
}

bool WindowDriver::settle()
{
    return QTest::qWaitFor(
        [this] {
            const auto tabs = window.workspace().tabs();
            return std::none_of(tabs.begin(), tabs.end(), [](editor::DocumentTab *tab) {
                return tab->document().isOpening() || tab->document().isSaving();
            });
        },
        20000);
}

bool WindowDriver::open(const QString &path)
{
    window.open({path});
    return settle() && window.workspace().current() && document().isOpen();
}

QString makeAnim(const QTemporaryDir &folder, const QString &name, const model::CompressionSettings &settings)
{
    constexpr std::uint32_t Side = 6;
    constexpr std::uint32_t Frames = 12;
    model::Connectivity connectivity{Side * Side, {}};
    for (std::uint32_t y = 0; y + 1 < Side; ++y)
        for (std::uint32_t x = 0; x + 1 < Side; ++x) {
            const std::uint32_t a = y * Side + x;
            connectivity.triangles.push_back({a, a + 1, a + Side});
            connectivity.triangles.push_back({a + 1, a + Side + 1, a + Side});
        }
    std::vector<model::Vec3f> positions;
    for (std::uint32_t frame = 0; frame < Frames; ++frame)
        for (std::uint32_t i = 0; i < Side * Side; ++i)
            positions.push_back({float(i % Side), std::sin(0.5f * float(frame) + 0.4f * float(i)), float(i / Side)});
    const model::Sequence sequence(connectivity, positions, 25, "wave");
    const auto encoded = model::codec::encodeAnimation(sequence, settings);
    const QString path = folder.filePath(name);
    if (!encoded || !model::io::saveBytes(path, encoded->bytes))
        QTest::qFail("the test file cannot be made", __FILE__, __LINE__);
    return path;
}

void withNextDialog(std::function<void(QDialog &)> what)
{
    auto *timer = new QTimer(qApp);
    timer->setInterval(20);
    QObject::connect(timer, &QTimer::timeout, qApp, [timer, what = std::move(what)] {
        auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget());
        if (!dialog || !dialog->isVisible())
            return;
        timer->stop();
        timer->deleteLater();
        what(*dialog);
    });
    timer->start();
}

void clickButton(QWidget &dialog, const QString &text)
{
    const auto buttons = dialog.findChildren<QAbstractButton *>();
    for (QAbstractButton *button : buttons)
        if (editor::plainTitle(button->text()) == text) {
            QTest::mouseClick(button, Qt::LeftButton);
            return;
        }
    QTest::qFail(qPrintable("no button " + text), __FILE__, __LINE__);
}

} // namespace tests
