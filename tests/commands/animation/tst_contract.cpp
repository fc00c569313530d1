// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/animation/animationcontext.h"
#include "commands/animation/normaliseanimation.h"
#include "commands/animation/renameanimation.h"
#include "commands/animation/resampleanimation.h"
#include "commands/animation/reverseanimation.h"
#include "commands/animation/setcompression.h"
#include "commands/animation/setframerate.h"
#include "commands/animation/trimanimation.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "tests/support/undocheck.h"

using namespace commands;
using model::AnimationDocument;

namespace {

struct Row
{
    const char *name;
    QString text;
    tests::CommandMaker make;
};

template <class Command, class... Args>
Row row(const char *name, const char *text, Args... args)
{
    return {name, QString::fromUtf8(text),
            [args...](AnimationDocument &document) { return std::make_unique<Command>(document, args...); }};
}

/// One row for each command, more where it has several faces. For a document of 10 frames at 25 fps.
const std::vector<Row> &changing()
{
    using Settings = model::CompressionSettings;
    static const std::vector<Row> rows{
        row<NormaliseAnimation>("normalise", "Normalise Animation", model::Similarity{0.5, {1, 2, 3}}),
        row<RenameAnimation>("rename", "Rename Animation", std::string("Žluťoučký kůň")),
        row<RenameAnimation>("rename to nothing", "Rename Animation", std::string()),
        row<ResampleAnimation>("resample to more", "Resample to 30 fps", 30.0),
        row<ResampleAnimation>("resample to fewer", "Resample to 7.5 fps", 7.5),
        row<ReverseAnimation>("reverse", "Reverse Animation"),
        row<SetCompression>("basis size", "Set Basis Size to 21", Settings{model::PcaSettings{21, 10000}}),
        row<SetCompression>("resolution", "Set Resolution to 500", Settings{model::PcaSettings{20, 500}}),
        row<SetCompression>("compression", "Change Compression", Settings{model::PcaSettings{21, 500}}),
        row<SetCompression>("compression in a gesture", "Set Basis Size to 21", Settings{model::PcaSettings{21, 10000}},
                            GestureId(1)),
        row<SetFrameRate>("frame rate", "Play at 12.5 fps", 12.5),
        row<SetFrameRate>("frame rate in a gesture", "Play at 12.5 fps", 12.5, GestureId(1)),
        row<TrimAnimation>("trim", "Trim to 4 Frame(s)", 3u, 6u),
        row<TrimAnimation>("trim to one", "Trim to 1 Frame(s)", 9u, 9u),
    };
    return rows;
}

/// The same commands asked for what is there already.
const std::vector<Row> &unchanging()
{
    static const std::vector<Row> rows{
        row<NormaliseAnimation>("normalise", "", model::Similarity()),
        row<RenameAnimation>("rename", "", std::string("wave")),
        row<ResampleAnimation>("resample", "", 25.0),
        row<SetCompression>("compression", "", model::CompressionSettings{model::PcaSettings()}),
        row<SetFrameRate>("frame rate", "", 25.0),
        row<TrimAnimation>("trim", "", 0u, 9u),
    };
    return rows;
}

std::unique_ptr<AnimationDocument> document()
{
    return std::make_unique<AnimationDocument>(tests::wave(tests::cube(), 10),
                                               model::CompressionSettings{model::PcaSettings()});
}

/// A document that was edited already: no value is that of the source.
std::unique_ptr<AnimationDocument> editedDocument()
{
    auto edited = std::make_unique<AnimationDocument>(tests::noise(tests::grid(), 24),
                                                      model::CompressionSettings{model::PcaSettings()});
    edited->setTiming({model::TimeMap::identity(24).reversed().trimmed(3, 20).resampled(30, 17), 25});
    edited->setPlacement({3, {0, -1, 0.5}});
    edited->setName("edited");
    return edited;
}

} // namespace

class TestContract final : public QObject
{
    Q_OBJECT

private slots:
    void everyCommandKeepsTheContract_data() { addRows(changing()); }
    void everyCommandKeepsTheContract()
    {
        QFETCH(int, index);
        const Row &row = changing()[std::size_t(index)];
        const auto fresh = document();
        QCOMPARE(row.make(*fresh)->text(), row.text);
        tests::checkUndoContract(*fresh, row.make);
        const auto edited = editedDocument();
        QCOMPARE(edited->frameCount(), 11u);
        tests::checkUndoContract(*edited, row.make);
    }

    void nothingIsPushedWhenNothingChanges_data() { addRows(unchanging()); }
    void nothingIsPushedWhenNothingChanges()
    {
        QFETCH(int, index);
        const auto fresh = document();
        AnimationContext context(*fresh);
        context.push<RenameAnimation>("to be redone");
        context.undoStack().undo();
        int notices = 0;
        connect(fresh.get(), &AnimationDocument::changed, fresh.get(), [&] { ++notices; });

        const std::uint64_t before = fresh->fingerprint();
        const Row &row = unchanging()[std::size_t(index)];
        QVERIFY(row.make(*fresh)->isObsolete());
        context.pushCommand(row.make(*fresh));
        QCOMPARE(context.undoStack().count(), 1);
        QVERIFY(context.undoStack().canRedo());
        QVERIFY(context.undoStack().isClean());
        QCOMPARE(notices, 0);
        QCOMPARE(fresh->fingerprint(), before);
    }

    void oneFrameCannotBeReversed()
    {
        AnimationDocument single(tests::oneFrame(tests::cube()));
        AnimationContext context(single);
        context.push<ReverseAnimation>();
        context.push<ResampleAnimation>(25.0);
        QCOMPARE(context.undoStack().count(), 0);
    }

private:
    static void addRows(const std::vector<Row> &rows)
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < rows.size(); ++i)
            QTest::newRow(rows[i].name) << int(i);
    }
};

SANDREEL_TEST(TestContract)
#include "tst_contract.moc"
