// SPDX-License-Identifier: GPL-3.0-or-later
// How long the editor's thread is away at a time, while a person works on a large terrain: for each thing that is done
// the longest event, what it was, how many took longer than 30 ms, and where they were after 30 ms; painting apart.
// Needs a display:
// xvfb-run build/release/bin/sandreel-bench-blocking [vertices, 1000000].
#include "app/editor/documents/terraintab.h"
#include "app/editor/start/language.h"
#include "app/editor/window/mainwindow.h"
#include "app/editor/window/theme.h"
#include "model/io/terrain/newterrain.h"
#include "views/terrain/terrainviewport.h"
#include "views/viewport/glsupport.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QMetaEnum>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <thread>

#include <cxxabi.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <pthread.h>
#include <signal.h>

namespace {

constexpr double Allowed = 30; ///< milliseconds
constexpr int Patience = 600'000;

/// Looks where the thread that made it is when an event takes longer than Allowed.
class Watch
{
public:
    Watch()
    {
        mInstance = this;
        void *warm[1];
        backtrace(warm, 1); // loads what it needs, which a signal handler must not
        signal(SIGUSR1, [](int) { mInstance->mDepth = backtrace(mInstance->mFrames, MostFrames); });
        mThread = std::thread([this, thread = pthread_self()] {
            while (!mEnd) {
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
                const std::int64_t begin = mBegin;
                if (begin == 0 || mSeen == begin || now() - begin < std::int64_t(Allowed * 1e6))
                    continue;
                mSeen = begin;
                pthread_kill(thread, SIGUSR1);
            }
        });
    }
    ~Watch()
    {
        mEnd = true;
        mThread.join();
    }
    void begin()
    {
        mDepth = 0;
        mBegin = now();
    }
    /// The innermost functions of ours in which it was found; empty if it was quick.
    QString end()
    {
        mBegin = 0;
        QStringList names;
        for (int i = 0; i < mDepth && names.size() < 3; ++i) {
            Dl_info info;
            if (!dladdr(mFrames[i], &info) || !info.dli_sname)
                continue;
            int status = 0;
            char *const text = abi::__cxa_demangle(info.dli_sname, nullptr, nullptr, &status);
            QString name = QString::fromLatin1(text ? text : info.dli_sname);
            std::free(text);
            name.truncate(name.indexOf(u'('));
            if (name.startsWith(QStringLiteral("editor::")) || name.startsWith(QStringLiteral("views::")) ||
                name.startsWith(QStringLiteral("model::")) || name.startsWith(QStringLiteral("commands::")))
                names << name;
        }
        return names.join(QStringLiteral(" < "));
    }

private:
    static constexpr int MostFrames = 60;
    static std::int64_t now()
    {
        return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
    }

    static inline Watch *mInstance = nullptr;
    std::thread mThread;
    std::atomic<std::int64_t> mBegin = 0, mSeen = 0;
    std::atomic<bool> mEnd = false;
    void *mFrames[MostFrames];
    int mDepth = 0;
};

struct Longest
{
    double milliseconds = 0;
    QString what;
    int beyond = 0;                ///< events longer than Allowed
    std::map<QString, int> places; ///< of those

    void add(double took, const QObject &receiver, QEvent::Type type, const QString &place)
    {
        beyond += took > Allowed;
        if (!place.isEmpty())
            ++places[place];
        if (took <= milliseconds)
            return;
        milliseconds = took;
        what = QStringLiteral("%1 to %2")
                   .arg(QLatin1String(QMetaEnum::fromType<QEvent::Type>().valueToKey(type)),
                        QLatin1String(receiver.metaObject()->className()));
    }
};

/// Takes the time of every event; of one that is sent while another is handled only the outer one's.
class TimedApplication final : public QApplication
{
public:
    using QApplication::QApplication;

    bool notify(QObject *receiver, QEvent *event) override
    {
        if (mDepth > 0)
            return QApplication::notify(receiver, event);
        // The receiver may be gone afterwards.
        const QEvent::Type type = event->type();
        const QPointer<QObject> still(receiver);
        QElapsedTimer clock;
        clock.start();
        mWatch.begin();
        ++mDepth;
        const bool handled = QApplication::notify(receiver, event);
        --mDepth;
        const double took = double(clock.nsecsElapsed()) * 1e-6;
        const QString place = mWatch.end();
        const bool paints = type == QEvent::UpdateRequest || type == QEvent::Paint || type == QEvent::Expose;
        (paints ? painting : other).add(took, still ? *still : *this, type, place);
        return handled;
    }

    Longest other, painting;

private:
    Watch mWatch;
    int mDepth = 0;
};

class Session
{
public:
    Session(TimedApplication &application, editor::MainWindow &window)
        : mApplication(application)
        , mWindow(window)
    {}

    /// Does it, waits until `isDone`, and prints a line.
    template <class Action, class Done>
    void measure(const char *name, Action action, Done isDone)
    {
        mApplication.other = mApplication.painting = {};
        QElapsedTimer clock;
        clock.start();
        action();
        // What begins in the next turn of the event loop has to have begun.
        QTest::qWait(50);
        const bool done = QTest::qWaitFor(isDone, Patience);
        QTest::qWait(300);
        print(name, double(clock.elapsed()) * 1e-3, done);
    }
    void trigger(const char *name, editor::ActionId id)
    {
        measure(
            name, [&] { mWindow.actions()[id].trigger(); }, [this] { return isIdle(); });
    }
    /// An action by its key, or a button of a dock.
    void press(const char *name, const char *objectName)
    {
        measure(
            name,
            [&] {
                if (auto *button = mWindow.findChild<QAbstractButton *>(QLatin1String(objectName)))
                    button->click();
                else
                    for (const auto &entry : mWindow.actions().entries())
                        if (entry.key() == QLatin1String(objectName))
                            entry.action->trigger();
            },
            [this] { return isIdle(); });
    }
    bool isIdle() const
    {
        const editor::DocumentTab *tab = mWindow.workspace().current();
        const editor::TerrainTab *terrain = mWindow.workspace().currentTerrain();
        return tab && !tab->document().isOpening() && !tab->document().isSaving() && terrain &&
               !terrain->viewport()->isLoading() && !terrain->document().context()->hasGesture() && !isRunning();
    }
    views::TerrainViewport &viewport() { return *mWindow.workspace().currentTerrain()->viewport(); }
    /// A curve over the ground, `seconds` long, at 100 events a second.
    void draw(double seconds)
    {
        const auto place = [&](double t) {
            return QPoint(int(viewport().width() * (0.5 + 0.2 * std::cos(1.7 * t))),
                          int(viewport().height() * (0.55 + 0.15 * std::sin(2.3 * t))));
        };
        QTest::mouseMove(&viewport(), place(0));
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, place(0));
        for (double t = 0; t < seconds; t += 0.01) {
            QTest::mouseMove(&viewport(), place(t));
            QTest::qWait(10);
        }
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, place(seconds));
    }

private:
    bool isRunning() const
    {
        const auto buttons = mWindow.findChildren<QPushButton *>(QStringLiteral("cancelJob"));
        return std::any_of(buttons.begin(), buttons.end(), [](const QPushButton *b) { return !b->isHidden(); });
    }
    void print(const char *name, double seconds, bool done)
    {
        const Longest &other = mApplication.other, &painting = mApplication.painting;
        std::printf("%-28s %7.1f s%s  longest %6.1f ms (%d above %.0f)  %-44s painting %6.1f ms (%d)\n", name, seconds,
                    done ? " " : "!", other.milliseconds, other.beyond, Allowed, qPrintable(other.what),
                    painting.milliseconds, painting.beyond);
        for (const auto &[place, times] : other.places)
            std::printf("    %4d x %s\n", times, qPrintable(place));
        std::fflush(stdout);
    }

    TimedApplication &mApplication;
    editor::MainWindow &mWindow;
};

QString makeDunes(const QTemporaryDir &folder, double vertices)
{
    model::io::NewTerrain description;
    description.width = description.depth = std::sqrt(vertices) - 1;
    description.spacing = 1;
    description.relief = {model::io::ReliefShape::Dunes, 12, 120, 1};
    description.layers = {{model::terrain::material(model::terrain::MaterialPreset::DrySand), 2}};
    const auto terrain = model::io::makeTerrain(description);
    const QString path = folder.filePath(QStringLiteral("dunes.terrain"));
    if (!terrain || !model::io::saveTerrain(path, *terrain, {})) {
        std::fprintf(stderr, "%s cannot be written\n", qPrintable(path));
        std::exit(1);
    }
    return path;
}

} // namespace

int main(int argc, char **argv)
{
    const QTemporaryDir folder;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("Sandreel"));
    QCoreApplication::setApplicationName(QStringLiteral("sandreel-bench-blocking"));
    views::setDefaultGlFormat();
    TimedApplication application(argc, argv);
    const double vertices = argc > 1 ? std::atof(argv[1]) : 1e6;
    const QString path = makeDunes(folder, vertices);

    editor::Language language;
    editor::applyTheme(editor::Theme::Light);
    language.apply(QStringLiteral("en"));
    editor::MainWindow window(language);
    window.resize(1280, 720);
    window.show();
    if (!QTest::qWaitForWindowExposed(&window))
        return 1;

    using editor::ActionId;
    Session session(application, window);
    const auto idle = [&] { return session.isIdle(); };
    std::printf("%.0f vertices, window of %d x %d\n", vertices, window.width(), window.height());
    session.measure(
        "open", [&] { window.open({path}); }, idle);
    session.measure(
        "stroke, 2 s, and its slide", [&] { session.draw(2); }, idle);
    session.trigger("undo", ActionId::Undo);
    session.trigger("redo", ActionId::Redo);
    session.trigger("save", ActionId::Save);
    session.press("take reference", "takeReference");
    session.press("colour by slope", "ground.slope");
    session.press("contours", "ground.contours");
    session.press("until settled", "settle");
    session.trigger("undo that", ActionId::Undo);
    session.trigger("redo that", ActionId::Redo);
    session.trigger("save again", ActionId::Save);
    session.trigger("reload", ActionId::Reload);
    session.measure(
        "close", [&] { window.actions()[ActionId::CloseTab].trigger(); },
        [&] { return window.workspace().tabs().empty(); });
    return 0;
}
