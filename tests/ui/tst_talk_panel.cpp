// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <memory>

#include "ui/people/TalkPanel.h"
#include "ui/shell/Theme.h"

using database::AttemptTalk;
using ui::people::TalkPanel;

namespace {

using Place = std::array<double, 3>;

AttemptTalk talk()
{
    AttemptTalk made;
    made.comments.push_back(
        {1, "Grace Hopper", "2026-11-20T10:00:00Z", "Here you pressed too hard.", Place{1.0, 2.0, 3.0}, 102'000});
    made.comments.push_back({2, "Ada Lovelace", "2026-11-20T12:00:00Z", "The bur slipped.", {}, {}});
    made.overrides.push_back({"Grace Hopper", "2026-11-20T11:00:00Z", 800, "The wall is fine by hand."});
    return made;
}

}  // namespace

class TestTalkPanel : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void theMachinesScoreStaysInSight();
    void everythingIsSignedAndInOrder();
    void whoMayNotWriteReads();
    void aCommentThatIsTooLongSaysSoBesideItsField();
    void aCommentIsPinned();
    void whatIsMarkedForACommentIsPinned();
    void pinsLeadThere();
    void aScoreNeedsAReason();
    void theScoreBeginsWithWhatCounts();
    void whatWasRefusedStaysTyped();
    void whatIsTypedStaysWithItsAttempt();
    void theKeyboardStaysWithTheComment();
    void theKeyboardStaysWithTheScoreThatWasGiven();
    void theWheelScrollsOverTheScore();
    void onesOwnCommentIsTakenBackToBeCorrected();
    void aDraftOutlastsACommentThatIsTakenBack();
    void wordsTakenBackOutlastAnotherAttempt();
    void whatWasTakenBackElsewhereGoesToo();
    void anAddedCommentLeavesItsFieldWhileAnotherIsTakenBack();
    void whatWasGivenMeanwhileIsNoDraft();
    void whatIsTypedCanBePutBy();
    void whatIsTypedBelongsToTheAttempt();
    void aScoreThatIsTypedMeanwhileIsAnother();
    void aRefusedTakeBackWakesNothingElse();
    void nothingIsSentTwice();
    void whatWasRefusedIsToldAtItsAttempt();
    void whatIsTickedStaysWhatItIs();
    void theMomentOneWentToIsTicked();
    void aPointAndACommaAreOne_data();
    void aPointAndACommaAreOne();
    void whatIsNoScoreIsNotMadeOne_data();
    void whatIsNoScoreIsNotMadeOne();
    void whatWasAddedMeanwhileIsNoDraft();

private:
    template <typename Widget>
    Widget* get(const char* name)
    {
        return m_panel->findChild<Widget*>(name);
    }
    QString words()
    {
        QStringList all;
        for (QLabel* label : m_panel->findChildren<QLabel*>())
            if (label->isVisible())
                all << label->text();
        return all.join(u'\n');
    }

    std::unique_ptr<TalkPanel> m_panel;
};

void TestTalkPanel::initTestCase()
{
    QLocale::setDefault(QLocale("en_GB"));
    ui::shell::applyTheme(*qApp, ui::shell::ThemeChoice::Light);
}

void TestTalkPanel::init()
{
    m_panel = std::make_unique<TalkPanel>(nullptr);
    m_panel->setMay(true, true);
    m_panel->setScore(684, 750, false);
    m_panel->resize(460, 640);
    m_panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
}

void TestTalkPanel::theMachinesScoreStaysInSight()
{
    QCOMPARE(get<QLabel>("counts")->text(), QString("68.4 points, not passed"));
    QVERIFY(!get<QPushButton>("machineAgain")->isVisible());
    m_panel->setTalk(talk());
    QCOMPARE(get<QLabel>("counts")->text(), QString("80.0 points, passed"));
    QCOMPARE(get<QLabel>("machine")->text(), QString("Given by Grace Hopper. The machine's score: 68.4 points."));
    QVERIFY(get<QPushButton>("machineAgain")->isVisible());
    AttemptTalk taken = talk();
    taken.overrides.push_back({"Grace Hopper", "2026-11-20T13:00:00Z", {}, "My mistake."});
    m_panel->setTalk(taken);
    QCOMPARE(get<QLabel>("counts")->text(), QString("68.4 points, not passed"));
    QVERIFY(words().contains("let the machine's score count again: My mistake."));
}

void TestTalkPanel::everythingIsSignedAndInOrder()
{
    m_panel->setTalk(talk());
    const QString all = words();
    const auto first = all.indexOf("Here you pressed too hard.");
    const auto second = all.indexOf("gave 80.0 points: The wall is fine by hand.");
    const auto third = all.indexOf("The bur slipped.");
    QVERIFY(first > 0 && second > first && third > second);
    QVERIFY(all.contains("Grace Hopper, 20/11/2026"));
}

void TestTalkPanel::whoMayNotWriteReads()
{
    m_panel->setTalk(talk());
    m_panel->setMay(false, false);
    QVERIFY(!get<QPlainTextEdit>("commentWords")->isVisible());
    QVERIFY(!get<QLineEdit>("reason")->isVisible());
    QVERIFY(words().contains("Here you pressed too hard."));
    m_panel->setTalk({});
    QVERIFY(get<QLabel>("noTalk")->text().contains("What an instructor says"));
}

void TestTalkPanel::aCommentThatIsTooLongSaysSoBesideItsField()
{
    auto* field = get<QPlainTextEdit>("commentWords");
    auto* room = get<QLabel>("commentRoom");
    field->setPlainText(QString(3000, 'w'));
    QVERIFY(!room->isVisible());
    field->setPlainText(QString(3990, 'w'));
    QVERIFY2(room->isVisible() && room->text().contains("10 more"), qPrintable(room->text()));
    QVERIFY(get<QPushButton>("addComment")->isEnabled());
    field->setPlainText(QString(4020, 'w'));
    QVERIFY2(room->text().startsWith("20 ") && room->text().contains("4,000"), qPrintable(room->text()));
    QVERIFY(!get<QPushButton>("addComment")->isEnabled());
}

void TestTalkPanel::aCommentIsPinned()
{
    std::optional<std::int64_t> moment;
    std::optional<Place> place;
    QString said;
    int asked = 0;
    connect(m_panel.get(), &TalkPanel::commentWanted, this,
            [&](const QString& w, std::optional<std::int64_t> m, std::optional<Place> p) {
                said = w;
                moment = m;
                place = p;
                ++asked;
            });
    QVERIFY(!get<QPushButton>("addComment")->isEnabled());
    QVERIFY(!get<QCheckBox>("atMoment")->isVisible());
    get<QPlainTextEdit>("commentWords")->setPlainText("  Lift the bur here. ");
    m_panel->setMoment(102'400);
    m_panel->setPlace(Place{1.0, 2.0, 3.0});
    QCOMPARE(get<QCheckBox>("atMoment")->text(), QString("at 1:42 of the replay"));
    get<QPushButton>("addComment")->click();
    QCOMPARE(said, QString("Lift the bur here."));
    QVERIFY(!moment && !place);
    m_panel->answer(0, "It could not be kept.");
    get<QCheckBox>("atMoment")->setChecked(true);
    get<QCheckBox>("atPlace")->setChecked(true);
    get<QPushButton>("addComment")->click();
    QCOMPARE(asked, 2);
    QCOMPARE(moment, std::optional<std::int64_t>(102'400));
    QCOMPARE(place, std::optional<Place>(Place{1.0, 2.0, 3.0}));
    // It was kept: the field is free for the next.
    AttemptTalk kept;
    kept.comments.push_back({3, "Grace Hopper", "2026-11-20T14:00:00Z", "Lift the bur here.", {}, {}});
    m_panel->answer(0);
    m_panel->setTalk(kept);
    QVERIFY(get<QPlainTextEdit>("commentWords")->toPlainText().isEmpty());
}

/// Marked by who writes; but not where he only looks at the place of another comment.
void TestTalkPanel::whatIsMarkedForACommentIsPinned()
{
    auto* how = get<QLabel>("howToPin");
    QVERIFY(how->text().contains("click a place"));
    m_panel->setPlace(Place{1.0, 2.0, 3.0}, true);
    QVERIFY(get<QCheckBox>("atPlace")->isChecked());
    QVERIFY(how->isVisible() && how->text().contains("play the attempt"));
    m_panel->setPlace(Place{4.0, 5.0, 6.0});
    QVERIFY(!get<QCheckBox>("atPlace")->isChecked());
    m_panel->setPlace({}, true);
    QVERIFY(!get<QCheckBox>("atPlace")->isChecked() && !get<QCheckBox>("atPlace")->isVisible());
    m_panel->setMoment(1000);
    m_panel->setPlace(Place{1.0, 2.0, 3.0}, true);
    QVERIFY(!how->isVisible());
    get<QCheckBox>("atMoment")->setChecked(true);
    // What was kept has its pins; the next comment begins without.
    get<QPlainTextEdit>("commentWords")->setPlainText("The bur slipped.");
    get<QPushButton>("addComment")->click();
    AttemptTalk kept;
    kept.comments.push_back(
        {3, "Grace Hopper", "2026-11-20T14:00:00Z", "The bur slipped.", Place{1.0, 2.0, 3.0}, 1000});
    m_panel->answer(0);
    m_panel->setTalk(kept);
    QVERIFY(!get<QCheckBox>("atPlace")->isChecked() && !get<QCheckBox>("atMoment")->isChecked());
}

void TestTalkPanel::pinsLeadThere()
{
    m_panel->setTalk(talk());
    double at = 0.0;
    Place place{};
    connect(m_panel.get(), &TalkPanel::momentWanted, this, [&](double seconds) { at = seconds; });
    connect(m_panel.get(), &TalkPanel::placeWanted, this, [&](Place p) { place = p; });
    for (QPushButton* button : m_panel->findChildren<QPushButton*>())
        if (button->property("kind") == "chip")
            button->click();
    QCOMPARE(at, 102.0);
    QCOMPARE(place, (Place{1.0, 2.0, 3.0}));
}

void TestTalkPanel::aScoreNeedsAReason()
{
    std::optional<std::optional<int>> given;
    QString why;
    connect(m_panel.get(), &TalkPanel::overrideWanted, this, [&](std::optional<int> tenths, const QString& reason) {
        given = tenths;
        why = reason;
    });
    QCOMPARE(get<QDoubleSpinBox>("givenPoints")->value(), 68.4);
    get<QDoubleSpinBox>("givenPoints")->setValue(77.7);
    QVERIFY(!get<QPushButton>("giveScore")->isEnabled());
    get<QLineEdit>("reason")->setText("   ");
    QVERIFY(!get<QPushButton>("giveScore")->isEnabled());
    get<QLineEdit>("reason")->setText("Wall seen by hand");
    get<QPushButton>("giveScore")->click();
    QVERIFY(given && *given == 777);
    QCOMPARE(why, QString("Wall seen by hand"));
    m_panel->answer(0, "It could not be kept.");
    m_panel->setTalk(talk());
    get<QPushButton>("machineAgain")->click();
    QVERIFY(given && !*given);
}

void TestTalkPanel::theScoreBeginsWithWhatCounts()
{
    auto* points = get<QDoubleSpinBox>("givenPoints");
    m_panel->setTalk(talk());
    QCOMPARE(points->value(), 80.0);
    // What somebody has begun to type outlasts a comment.
    points->setValue(77.7);
    AttemptTalk commented = talk();
    commented.comments.push_back({3, "Grace Hopper", "2026-11-20T14:00:00Z", "Lift the bur here.", {}, {}});
    m_panel->setTalk(commented);
    QCOMPARE(points->value(), 77.7);
    // Another attempt begins with its own; typed points wait, with a reason or without.
    QCOMPARE(m_panel->unkeptScores(), QList<qint64>{0});
    m_panel->setAttempt(8);
    m_panel->setScore(500, 750, false);
    m_panel->setTalk({});
    QCOMPARE(points->value(), 50.0);
    m_panel->setAttempt(0);
    m_panel->setScore(684, 750, false);
    m_panel->setTalk(talk());
    QCOMPARE(points->value(), 77.7);
    points->setValue(80.0);
    QVERIFY(m_panel->unkeptScores().isEmpty());
}

void TestTalkPanel::whatWasRefusedStaysTyped()
{
    get<QPlainTextEdit>("commentWords")->setPlainText("Lift the bur here.");
    get<QPushButton>("addComment")->click();
    m_panel->answer(0, "The database cannot be reached.");
    QVERIFY(get<QLabel>("fault")->isVisible());
    QCOMPARE(get<QPlainTextEdit>("commentWords")->toPlainText(), QString("Lift the bur here."));
    get<QPushButton>("addComment")->click();
    QVERIFY(!get<QLabel>("fault")->isVisible());
}

/// With what it is pinned to, and a reason with its number. It is shown with no other, and to nobody else.
void TestTalkPanel::whatIsTypedStaysWithItsAttempt()
{
    auto* words = get<QPlainTextEdit>("commentWords");
    auto* reason = get<QLineEdit>("reason");
    m_panel->setWriter("1");
    m_panel->setAttempt(7);
    m_panel->setMoment(4500);
    m_panel->setPlace(std::array<double, 3>{1.0, 2.0, 3.0}, true);
    get<QCheckBox>("atMoment")->setChecked(true);
    words->setPlainText("Half a sentence");
    QVERIFY(m_panel->unkeptScores().isEmpty());
    reason->setText("Half a reason");
    get<QDoubleSpinBox>("givenPoints")->setValue(45.5);
    m_panel->refuse("It could not be kept.");
    m_panel->setAttempt(8);
    m_panel->setScore(684, 750, false);
    QCOMPARE(words->toPlainText(), QString());
    QCOMPARE(reason->text(), QString());
    QCOMPARE(get<QDoubleSpinBox>("givenPoints")->value(), 68.4);
    for (const char* pin : {"atMoment", "atPlace"})
        QVERIFY(!get<QCheckBox>(pin)->isChecked() && !get<QCheckBox>(pin)->isVisible());
    QVERIFY(!get<QLabel>("fault")->isVisible());
    QCOMPARE(m_panel->unkeptComments(), QList<qint64>{7});
    QCOMPARE(m_panel->unkeptScores(), QList<qint64>{7});
    words->setPlainText("Of another");
    QCOMPARE(m_panel->unkeptComments(), (QList<qint64>{8, 7}));
    m_panel->setAttempt(0);  // work that is on the table
    m_panel->setAttempt(7);
    m_panel->setScore(684, 750, false);
    QCOMPARE(words->toPlainText(), QString("Half a sentence"));
    QCOMPARE(reason->text(), QString("Half a reason"));
    QCOMPARE(get<QDoubleSpinBox>("givenPoints")->value(), 45.5);
    QSignalSpy wanted(m_panel.get(), &TalkPanel::commentWanted);
    get<QPushButton>("addComment")->click();
    QCOMPARE(wanted.size(), 1);
    QCOMPARE(wanted[0][1].value<std::optional<std::int64_t>>(), std::optional<std::int64_t>(4500));
    const auto place = wanted[0][2].value<std::optional<std::array<double, 3>>>();
    QVERIFY(place.has_value());
    // Who comes next sees nothing of it, and it is there again for who was writing.
    QVERIFY(m_panel->waiting(false).isEmpty());
    m_panel->setWriter("2");
    QVERIFY(m_panel->unkeptComments().isEmpty() && m_panel->unkeptScores().isEmpty() &&
            !m_panel->waiting(false).isEmpty());
    for (const qint64 attempt : {7, 8}) {
        m_panel->setAttempt(attempt);
        QCOMPARE(words->toPlainText(), QString());
        QCOMPARE(reason->text(), QString());
    }
    m_panel->setWriter("3");
    QVERIFY(!m_panel->waiting(false).isEmpty());
    m_panel->setAttempt(7);
    QVERIFY(!get<QCheckBox>("atMoment")->isChecked() && !m_panel->place());
    m_panel->setScore(684, 750, false);
    QCOMPARE(get<QDoubleSpinBox>("givenPoints")->value(), 68.4);
    m_panel->setWriter("1");
    m_panel->setAttempt(7);
    QCOMPARE(words->toPlainText(), QString("Half a sentence"));
    QCOMPARE(reason->text(), QString("Half a reason"));
    QCOMPARE(get<QDoubleSpinBox>("givenPoints")->value(), 45.5);
    QVERIFY(get<QCheckBox>("atMoment")->isChecked() && m_panel->place() && m_panel->waiting(false).isEmpty());
}

/// The button rests once the comment is there; a digit that is typed next must not become the score.
void TestTalkPanel::theKeyboardStaysWithTheComment()
{
    auto* comment = get<QPlainTextEdit>("commentWords");
    comment->setPlainText("Lift the bur here.");
    get<QPushButton>("addComment")->setFocus();
    QTest::keyClick(get<QPushButton>("addComment"), Qt::Key_Space);
    QSignalSpy used(m_panel.get(), &TalkPanel::formUsed);
    AttemptTalk kept;
    kept.comments.push_back({3, "Grace Hopper", "2026-11-20T14:00:00Z", "Lift the bur here.", {}, {}});
    m_panel->answer(0);
    m_panel->setTalk(kept);
    QVERIFY(m_panel->focusWidget() == comment);
    QVERIFY(!used.isEmpty());
    QVERIFY(used.last().first().value<QWidget*>()->isAncestorOf(comment));
    QCOMPARE(get<QDoubleSpinBox>("givenPoints")->value(), 68.4);
}

void TestTalkPanel::theKeyboardStaysWithTheScoreThatWasGiven()
{
    auto* reason = get<QLineEdit>("reason");
    reason->setText("The wall is fine by hand.");
    get<QPushButton>("giveScore")->setFocus();
    QTest::keyClick(get<QPushButton>("giveScore"), Qt::Key_Space);
    AttemptTalk kept;
    kept.overrides.push_back({"Grace Hopper", "2026-11-20T11:00:00Z", 800, "The wall is fine by hand."});
    m_panel->answer(0);
    m_panel->setTalk(kept);
    QVERIFY(m_panel->focusWidget() == reason && reason->text().isEmpty());
    // Who writes nothing is left where he is.
    reason->clearFocus();
    QSignalSpy used(m_panel.get(), &TalkPanel::formUsed);
    m_panel->setTalk(talk());
    QCOMPARE(used.count(), 0);
}

void TestTalkPanel::theWheelScrollsOverTheScore()
{
    auto* points = get<QDoubleSpinBox>("givenPoints");
    get<QPlainTextEdit>("commentWords")->setFocus();
    const double before = points->value();
    const QPointF at = points->rect().center();
    for (int notch = 0; notch < 5; ++notch) {
        QWheelEvent wheel(at, points->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(points, &wheel);
    }
    QCOMPARE(points->value(), before);
    QVERIFY(!points->hasFocus());
    QVERIFY(!(points->focusPolicy() & Qt::WheelFocus & ~Qt::StrongFocus));
}

void TestTalkPanel::onesOwnCommentIsTakenBackToBeCorrected()
{
    auto* field = get<QPlainTextEdit>("commentWords");
    AttemptTalk mine = talk();
    mine.comments.front().isMine = true;
    m_panel->setTalk(mine);
    QCOMPARE(m_panel->findChildren<QPushButton*>("takeBack").size(), 1);
    auto* button = get<QPushButton>("takeBack");
    QVERIFY2(button->accessibleName().startsWith("Take back your comment of 20/11/2026"),
             qPrintable(button->accessibleName()));
    QSignalSpy wanted(m_panel.get(), &TalkPanel::withdrawWanted);
    QSignalSpy shown(m_panel.get(), &TalkPanel::placeWanted);
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Space);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted.first().first().toLongLong(), 1);
    QVERIFY(field->toPlainText().isEmpty());

    m_panel->withdraw(1, false);
    QVERIFY(!words().contains("Here you pressed too hard."));
    QCOMPARE(field->toPlainText(), QString("Here you pressed too hard."));
    QVERIFY(get<QCheckBox>("atMoment")->isChecked() && get<QCheckBox>("atPlace")->isChecked());
    QCOMPARE(shown.count(), 1);
    QVERIFY(m_panel->focusWidget() == field);
    auto* said = get<QLabel>("commentSaid");
    QVERIFY2(said->isVisible() && said->text().startsWith("Taken back."), qPrintable(said->text()));
    // It has gone from the database as well; what is to be corrected stays.
    AttemptTalk left = talk();
    left.comments.erase(left.comments.begin());
    m_panel->setTalk(left);
    QCOMPARE(field->toPlainText(), QString("Here you pressed too hard."));
    get<QPushButton>("addComment")->click();
    QVERIFY(!said->isVisible());
    // Who only reads takes nothing back.
    m_panel->setTalk(mine);
    m_panel->setMay(false, false);
    QVERIFY(get<QPushButton>("takeBack") == nullptr);
}

void TestTalkPanel::aDraftOutlastsACommentThatIsTakenBack()
{
    auto* field = get<QPlainTextEdit>("commentWords");
    AttemptTalk mine = talk();
    mine.comments.front().isMine = true;
    m_panel->setTalk(mine);
    field->setPlainText("Half a sentence");
    m_panel->withdraw(1, false);
    QVERIFY(!words().contains("Here you pressed too hard."));
    QCOMPARE(field->toPlainText(), QString("Half a sentence\n\nHere you pressed too hard."));
    QVERIFY(get<QLabel>("commentSaid")->text().contains("below what you are writing"));
    // It was said of this attempt.
    m_panel->setAttempt(8);
    QVERIFY(!get<QLabel>("commentSaid")->isVisible());
}

/// They wait with the attempt that they are about.
void TestTalkPanel::wordsTakenBackOutlastAnotherAttempt()
{
    auto* field = get<QPlainTextEdit>("commentWords");
    AttemptTalk mine = talk();
    mine.comments.front().isMine = true;
    m_panel->setAttempt(7);
    m_panel->setTalk(mine);
    get<QPushButton>("takeBack")->click();
    m_panel->setAttempt(8);
    m_panel->setTalk({});
    m_panel->withdraw(1, false);
    QVERIFY(field->toPlainText().isEmpty());
    m_panel->setAttempt(7);
    QCOMPARE(field->toPlainText(), QString("Here you pressed too hard."));
}

/// And is not written again: it may have been, there.
void TestTalkPanel::whatWasTakenBackElsewhereGoesToo()
{
    auto* field = get<QPlainTextEdit>("commentWords");
    AttemptTalk mine = talk();
    mine.comments.front().isMine = true;
    m_panel->setTalk(mine);
    m_panel->withdraw(1, true);
    QVERIFY(!words().contains("Here you pressed too hard."));
    QVERIFY(field->toPlainText().isEmpty());
    QCOMPARE(get<QLabel>("commentSaid")->text(), QString("This comment had been taken back already."));
    // Pressed twice it says so once.
    m_panel->setTalk(mine);
    m_panel->withdraw(1, false);
    m_panel->withdraw(1, true);
    QVERIFY(get<QLabel>("commentSaid")->text().startsWith("Taken back."));
}

/// However many there are then, and whose is the last.
void TestTalkPanel::anAddedCommentLeavesItsFieldWhileAnotherIsTakenBack()
{
    auto* field = get<QPlainTextEdit>("commentWords");
    m_panel->setTalk(talk());
    field->setPlainText("Lift the bur here.");
    get<QPushButton>("addComment")->click();
    m_panel->answer(0);
    AttemptTalk now = talk();
    now.comments.front() = {3, "Grace Hopper", "2026-11-20T14:00:00Z", "Lift the bur here.", {}, {}};
    std::swap(now.comments.front(), now.comments.back());
    now.comments.back() = {4, "Ada Lovelace", "2026-11-20T14:00:01Z", "Mine, too.", {}, {}};
    m_panel->setTalk(now);
    QVERIFY(field->toPlainText().isEmpty());
    // The same words again are another comment.
    field->setPlainText("Mine, too.");
    m_panel->setTalk(talk());
    m_panel->setTalk(now);
    QCOMPARE(field->toPlainText(), QString("Mine, too."));
}

/// Its writer has gone when the answer comes: somebody else's it is not.
void TestTalkPanel::whatWasAddedMeanwhileIsNoDraft()
{
    auto* field = get<QPlainTextEdit>("commentWords");
    m_panel->setWriter("7");
    m_panel->setAttempt(1);
    m_panel->setTalk(talk());
    field->setPlainText("Lift the bur here.");
    get<QPushButton>("addComment")->click();
    m_panel->setWriter("8");
    QVERIFY(field->toPlainText().isEmpty());
    m_panel->setWriter("7");
    m_panel->setAttempt(1);
    QCOMPARE(field->toPlainText(), QString("Lift the bur here."));
    AttemptTalk added = talk();
    added.comments.push_back({9, "Grace Hopper", "2026-11-20T13:00:00Z", "Lift the bur here.", {}, {}, true});
    m_panel->setTalk(added);
    QVERIFY(field->toPlainText().isEmpty());
    // The same words once more are wanted.
    field->setPlainText("Lift the bur here.");
    m_panel->setTalk(added);
    QCOMPARE(field->toPlainText(), QString("Lift the bur here."));
}

/// The same of a score; the machine's that counts again is one.
void TestTalkPanel::whatWasGivenMeanwhileIsNoDraft()
{
    for (const bool isMachines : {false, true}) {
        AttemptTalk before = talk();
        before.overrides = {{"Grace Hopper", "2026-11-20T12:00:00Z", 400, "Two steps"}};
        m_panel->setWriter("7");
        m_panel->setAttempt(1);
        m_panel->setScore(684, 750, false);
        m_panel->setTalk(before);
        get<QDoubleSpinBox>("givenPoints")->setValue(50.5);
        get<QLineEdit>("reason")->setText("Steady hand");
        get<QPushButton>(isMachines ? "machineAgain" : "giveScore")->click();
        m_panel->setWriter("8");
        m_panel->setWriter("7");
        m_panel->setAttempt(1);
        m_panel->setTalk({});  // not read yet
        QVERIFY(m_panel->unkeptScores().size() == 1);
        AttemptTalk given = before;
        given.overrides.push_back(
            {"Grace Hopper", "2026-11-20T13:00:00Z", isMachines ? std::nullopt : std::optional(505), "Steady hand"});
        m_panel->setTalk(given);
        QVERIFY(m_panel->unkeptScores().isEmpty() && get<QLineEdit>("reason")->text().isEmpty());
    }
}

/// Until he comes back: on the disk, say.
void TestTalkPanel::whatIsTypedCanBePutBy()
{
    m_panel->setWriter("7");
    m_panel->setAttempt(1);
    m_panel->setTalk(talk());
    m_panel->setScore(684, 750, false);
    m_panel->setMoment(4500);
    m_panel->setPlace(std::array<double, 3>{1.0, 2.0, 3.0}, true);
    get<QCheckBox>("atMoment")->setChecked(true);
    get<QPlainTextEdit>("commentWords")->setPlainText("Half a sentence");
    m_panel->setAttempt(2);
    m_panel->setScore(684, 750, false);
    get<QDoubleSpinBox>("givenPoints")->setValue(45.5);
    QVERIFY(m_panel->waiting(false).isEmpty());
    const QJsonArray typed = m_panel->waiting(true);
    QCOMPARE(typed.size(), 2);
    m_panel->setWriter("8");
    QCOMPARE(m_panel->waiting(false), typed);
    // Half a reason is no score of nothing.
    m_panel->setAttempt(3);
    m_panel->setScore(400, 750, false);
    get<QLineEdit>("reason")->setText("Half a reason");
    for (const QJsonValue one : m_panel->waiting(true))
        if (one.toObject()["attempt"].toInt() == 3) {
            TalkPanel another(nullptr);
            QVERIFY(another.goOnWith(one.toObject()));
            another.setWriter(one.toObject()["person"].toString());
            another.setAttempt(3);
            QCOMPARE(another.findChild<QDoubleSpinBox*>("givenPoints")->value(), 40.0);
        }
    // In another window nobody else sees it.
    TalkPanel next(nullptr);
    for (const QJsonValue one : typed)
        QVERIFY(next.goOnWith(one.toObject()));
    QVERIFY(next.goOnWith(typed[0].toObject()));  // the same once more is no more
    QVERIFY(!next.goOnWith({}) && !next.goOnWith({{"person", "9"}, {"attempt", 0}}));
    next.setWriter("8");
    next.setAttempt(1);
    QVERIFY(next.unkeptComments().isEmpty() && next.unkeptScores().isEmpty());
    QCOMPARE(next.waiting(false), typed);
    next.setWriter("7");
    QVERIFY(next.waiting(false).isEmpty());
    QCOMPARE(next.unkeptScores(), QList<qint64>{2});
    next.setAttempt(1);
    QCOMPARE(next.findChild<QPlainTextEdit*>("commentWords")->toPlainText(), QString("Half a sentence"));
    QVERIFY(next.findChild<QCheckBox*>("atMoment")->isChecked() && next.findChild<QCheckBox*>("atPlace")->isChecked());
    QCOMPARE(next.place(), std::optional(std::array<double, 3>{1.0, 2.0, 3.0}));
    // It had been added after all.
    AttemptTalk added = talk();
    added.comments.push_back({9, "Grace Hopper", "2026-11-20T13:00:00Z", "Half a sentence", {}, {}, true});
    next.setTalk(added);
    QVERIFY(next.unkeptComments().isEmpty());
}

/// Whatever the row is called after a backup was put back.
void TestTalkPanel::whatIsTypedBelongsToTheAttempt()
{
    m_panel->setWriter("7");
    m_panel->setAttempt(1, "aa");
    get<QPlainTextEdit>("commentWords")->setPlainText("Half a sentence");
    m_panel->setAttempt(0);
    const QJsonArray typed = m_panel->waiting(true);
    QCOMPARE(typed.size(), 1);
    TalkPanel next(nullptr);
    QVERIFY(next.goOnWith(typed[0].toObject()));
    next.setWriter("7");
    const auto* words = next.findChild<QPlainTextEdit*>("commentWords");
    next.setAttempt(1, "bb");
    QVERIFY(words->toPlainText().isEmpty());
    QCOMPARE(next.unkeptComments().size(), 1);
    next.setAttempt(2, "aa");
    QCOMPARE(words->toPlainText(), QString("Half a sentence"));
    QCOMPARE(next.unkeptComments(), QList<qint64>{2});
    // What cannot be reached any more is told by its words, and goes.
    next.setAttempt(1, "bb");
    QCOMPARE(next.typedOn(2), QString("Half a sentence"));
    next.forget(2);
    QVERIFY(next.unkeptComments().isEmpty());
}

/// And waits to be given.
void TestTalkPanel::aScoreThatIsTypedMeanwhileIsAnother()
{
    m_panel->setAttempt(1);
    m_panel->setScore(684, 750, false);
    get<QLineEdit>("reason")->setText("Steady hand");
    get<QDoubleSpinBox>("givenPoints")->setValue(50.0);
    get<QPushButton>("giveScore")->click();
    get<QDoubleSpinBox>("givenPoints")->setValue(60.0);
    m_panel->answer(1);
    QCOMPARE(get<QDoubleSpinBox>("givenPoints")->value(), 60.0);
    QCOMPARE(get<QLineEdit>("reason")->text(), QString("Steady hand"));
}

/// What is on its way still rests.
void TestTalkPanel::aRefusedTakeBackWakesNothingElse()
{
    AttemptTalk mine = talk();
    mine.comments.front().isMine = true;
    m_panel->setWriter("7");
    m_panel->setAttempt(1);
    m_panel->setTalk(mine);
    get<QPlainTextEdit>("commentWords")->setPlainText("Lift the bur here.");
    get<QPushButton>("addComment")->click();
    get<QPushButton>("takeBack")->click();
    QVERIFY(!get<QPushButton>("takeBack")->isEnabled());
    m_panel->keepComment(1, 1, "The school does not answer.");
    QVERIFY(get<QPushButton>("takeBack")->isEnabled() && !get<QPushButton>("addComment")->isEnabled());
    QCOMPARE(get<QLabel>("fault")->text(), QString("The school does not answer."));
    m_panel->answer(1);
    QVERIFY(get<QPlainTextEdit>("commentWords")->toPlainText().isEmpty());
}

void TestTalkPanel::nothingIsSentTwice()
{
    auto* add = get<QPushButton>("addComment");
    auto* give = get<QPushButton>("giveScore");
    AttemptTalk mine = talk();
    mine.comments.front().isMine = true;
    m_panel->setTalk(mine);
    get<QPlainTextEdit>("commentWords")->setPlainText("Lift the bur here.");
    get<QLineEdit>("reason")->setText("The wall is fine by hand.");
    QSignalSpy comments(m_panel.get(), &TalkPanel::commentWanted);
    QSignalSpy scores(m_panel.get(), &TalkPanel::overrideWanted);
    QSignalSpy withdrawals(m_panel.get(), &TalkPanel::withdrawWanted);
    for (int press = 0; press < 3; ++press)
        add->click();
    QVERIFY(comments.size() == 1 && !add->isEnabled());
    get<QPlainTextEdit>("commentWords")->insertPlainText("More. ");
    QVERIFY(!add->isEnabled());
    m_panel->answer(0, "It could not be kept.");
    QVERIFY(add->isEnabled());
    for (int press = 0; press < 3; ++press)
        give->click();
    QVERIFY(scores.size() == 1 && !give->isEnabled() && !get<QPushButton>("machineAgain")->isEnabled());
    m_panel->answer(0);
    QVERIFY(get<QLineEdit>("reason")->text().isEmpty());
    for (int press = 0; press < 3; ++press)
        get<QPushButton>("takeBack")->click();
    QVERIFY(withdrawals.size() == 1 && !get<QPushButton>("takeBack")->isEnabled());
    m_panel->keepComment(1, 0, "It could not be done.");
    QVERIFY(get<QPushButton>("takeBack")->isEnabled());
}

/// Where another is shown by then, it stands there on return.
void TestTalkPanel::whatWasRefusedIsToldAtItsAttempt()
{
    auto* fault = get<QLabel>("fault");
    auto* field = get<QPlainTextEdit>("commentWords");
    m_panel->setAttempt(7);
    field->setPlainText("Lift the bur here.");
    get<QPushButton>("addComment")->click();
    m_panel->setAttempt(8);
    m_panel->answer(7, "It could not be kept.");
    QVERIFY(!fault->isVisible());
    m_panel->setAttempt(7);
    QVERIFY(fault->isVisible() && fault->text() == "It could not be kept.");
    QCOMPARE(field->toPlainText(), QString("Lift the bur here."));
    // What is kept meanwhile does not wait there.
    get<QPushButton>("addComment")->click();
    m_panel->setAttempt(8);
    m_panel->answer(7);
    QVERIFY(m_panel->unkeptComments().isEmpty());
    m_panel->setAttempt(7);
    QVERIFY(!fault->isVisible() && field->toPlainText().isEmpty());
}

/// Whoever looks at another place, or at the replay, does not mean his comment.
void TestTalkPanel::whatIsTickedStaysWhatItIs()
{
    auto* atMoment = get<QCheckBox>("atMoment");
    get<QPlainTextEdit>("commentWords")->setPlainText("Half a sentence");
    m_panel->setPlace(Place{1.0, 2.0, 3.0}, true);
    m_panel->setMoment(4157);
    atMoment->setChecked(true);
    m_panel->setPlace(Place{4.0, 5.0, 6.0});
    QVERIFY(get<QCheckBox>("atPlace")->isChecked());
    QCOMPARE(m_panel->place(), std::optional<Place>(Place{1.0, 2.0, 3.0}));
    m_panel->setMoment(1000);
    QCOMPARE(atMoment->text(), QString("at 0:04 of the replay"));
    atMoment->setChecked(false);
    QCOMPARE(atMoment->text(), QString("at 0:01 of the replay"));
    m_panel->setMoment(2000);
    QCOMPARE(atMoment->text(), QString("at 0:02 of the replay"));
}

/// As a place is that he clicks on.
void TestTalkPanel::theMomentOneWentToIsTicked()
{
    auto* atMoment = get<QCheckBox>("atMoment");
    const auto goTo = [this](std::int64_t ms) {
        m_panel->hide();
        m_panel->setMoment(0);
        m_panel->setMoment(ms);
        m_panel->show();
    };
    goTo(34'000);
    QVERIFY(atMoment->isVisible() && !atMoment->isChecked());  // he writes nothing
    auto* words = get<QPlainTextEdit>("commentWords");
    words->setPlainText("Here you press too hard");
    goTo(34'000);
    QVERIFY(atMoment->isChecked());
    QCOMPARE(atMoment->text(), QString("at 0:34 of the replay"));
    // He looks on, and it stays.
    goTo(70'000);
    QVERIFY(atMoment->isChecked());
    QCOMPARE(atMoment->text(), QString("at 0:34 of the replay"));
    // To have been elsewhere is not to have gone to a moment, nor is to look at what another is pinned to.
    atMoment->setChecked(false);
    m_panel->hide();
    m_panel->show();
    QVERIFY(!atMoment->isChecked());
    m_panel->setTalk(talk());
    for (QPushButton* button : m_panel->findChildren<QPushButton*>())
        if (button->accessibleName().startsWith("Show the moment"))
            button->click();
    goTo(102'400);
    QVERIFY(!atMoment->isChecked());
    goTo(102'400);
    QVERIFY(atMoment->isChecked());
}

void TestTalkPanel::aPointAndACommaAreOne_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("typed");
    for (const char* language : {"en_GB", "de_DE", "es_ES", "ja_JP"})
        for (const char* typed : {"9.5", "9,5"})
            QTest::addRow("%s in %s", typed, language) << QString(language) << QString(typed);
}

/// Else a score that is typed with the sign of another language is ten times as large.
void TestTalkPanel::aPointAndACommaAreOne()
{
    QFETCH(QString, language);
    QFETCH(QString, typed);
    QLocale::setDefault(QLocale(language));
    const auto back = qScopeGuard([] { QLocale::setDefault(QLocale("en_GB")); });
    TalkPanel panel(nullptr);
    panel.setMay(true, true);
    auto* points = panel.findChild<QDoubleSpinBox*>("givenPoints");
    points->selectAll();
    QTest::keyClicks(points, typed);
    QCOMPARE(points->value(), 9.5);
}

void TestTalkPanel::whatIsNoScoreIsNotMadeOne_data()
{
    QTest::addColumn<QString>("typed");
    for (const char* typed : {"950", "101", "9500", "-5", "100.1"})
        QTest::newRow(typed) << QString(typed);
}

/// It stays as it was typed, and is not given.
void TestTalkPanel::whatIsNoScoreIsNotMadeOne()
{
    QFETCH(QString, typed);
    QSignalSpy wanted(m_panel.get(), &TalkPanel::overrideWanted);
    auto* points = get<QDoubleSpinBox>("givenPoints");
    get<QLineEdit>("reason")->setText("by hand");
    QApplication::processEvents();
    const QRect before = get<QPushButton>("giveScore")->geometry();
    points->selectAll();
    QTest::keyClicks(points, typed);
    QTest::qWait(50);
    QCOMPARE(get<QPushButton>("giveScore")->geometry(), before);  // it does not move under the pointer
    QVERIFY(points->value() < 0.0 || points->value() > 100.0);
    QVERIFY(!get<QPushButton>("giveScore")->isEnabled());
    QVERIFY2(get<QLabel>("pointsBeyond")->isVisible(), "nothing is said of it");
    QTest::keyClick(get<QLineEdit>("reason"), Qt::Key_Return);
    QCOMPARE(wanted.count(), 0);
    points->selectAll();
    QTest::keyClicks(points, "100");
    QVERIFY(!get<QLabel>("pointsBeyond")->isVisible());
    get<QPushButton>("giveScore")->click();
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted[0][0].value<std::optional<int>>(), std::optional<int>(1000));
}

QTEST_MAIN(TestTalkPanel)
#include "tst_talk_panel.moc"
