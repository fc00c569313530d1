// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/animationdocument.h"
#include "tests/support/validateanimation.h"

#include <QTest>
#include <QUndoStack>

#include <functional>
#include <memory>

namespace tests {

/// Every position of every frame, to compare what a user sees and not only the fingerprint.
inline std::vector<std::vector<model::Vec3f>> allFramesOf(const model::FrameSource &source)
{
    std::vector<std::vector<model::Vec3f>> frames;
    for (std::uint32_t frame = 0; frame < source.frameCount(); ++frame)
        frames.push_back(source.frame(frame));
    return frames;
}

using CommandMaker = std::function<std::unique_ptr<QUndoCommand>(model::AnimationDocument &)>;

/// What every command owes: making it changes nothing; it has a text; carrying it out changes the fingerprint; undo and
/// redo, twice, bring both states back exactly; each step sends at least one notice; the document is valid throughout.
/// Precondition: the command changes something in `document`.
inline void checkUndoContract(model::AnimationDocument &document, const CommandMaker &make)
{
    const auto valid = [&document] {
        const std::vector<std::string> broken = brokenRules(document);
        for (const std::string &rule : broken)
            qWarning("broken: %s", rule.c_str());
        return broken.empty();
    };
    int notices = 0;
    const QMetaObject::Connection connection =
        QObject::connect(&document, &model::AnimationDocument::changed, &document, [&] {
            ++notices;
            if (!valid()) // Sent only while the state is whole.
                QTest::qFail("invalid when the notice is sent", __FILE__, __LINE__);
        });

    QVERIFY(valid());
    const std::uint64_t before = document.fingerprint();
    const auto framesBefore = allFramesOf(*document.frames());
    std::unique_ptr<QUndoCommand> command = make(document);
    QCOMPARE(document.fingerprint(), before);
    QCOMPARE(notices, 0);
    QVERIFY(!command->isObsolete());
    QVERIFY(!command->text().isEmpty());
    QVERIFY2(!command->text().contains(QLatin1Char('%')), qPrintable(command->text()));

    QUndoStack stack;
    stack.push(command.release());
    QCOMPARE(stack.count(), 1);
    QVERIFY(notices >= 1);
    QVERIFY(valid());
    const std::uint64_t after = document.fingerprint();
    QVERIFY(after != before);
    const auto framesAfter = allFramesOf(*document.frames());

    for (int round = 0; round < 2; ++round) {
        notices = 0;
        stack.undo();
        QVERIFY(notices >= 1);
        QVERIFY(valid());
        QCOMPARE(document.fingerprint(), before);
        QVERIFY(allFramesOf(*document.frames()) == framesBefore);
        notices = 0;
        stack.redo();
        QVERIFY(notices >= 1);
        QVERIFY(valid());
        QCOMPARE(document.fingerprint(), after);
        QVERIFY(allFramesOf(*document.frames()) == framesAfter);
    }
    QObject::disconnect(connection);
}

} // namespace tests
