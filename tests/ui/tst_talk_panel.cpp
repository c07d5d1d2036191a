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

#include <memory>
#include <tuple>

#include "tests/support/Suite.h"
#include "ui/kit/Theme.h"
#include "ui/scoring/CommentsPanel.h"

using database::AttemptTalk;
using ui::scoring::CommentsPanel;

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
    void initTestCase()
    {
        QLocale::setDefault(QLocale("en_GB"));
        ui::kit::applyTheme(*qApp, ui::kit::ThemeChoice::Light);
    }

    void init()
    {
        m_panel = std::make_unique<CommentsPanel>(nullptr);
        m_panel->setMay(true, true);
        m_panel->setScore(684, 750, false);
        m_panel->resize(460, 640);
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
    }

    void theMachinesScoreStaysInSight()
    {
        QCOMPARE(get<QLabel>("counts")->text(), QString("68.4 points, not passed"));
        QVERIFY(!get<QPushButton>("machineAgain")->isVisible());
        m_panel->setTalk(talk());
        QCOMPARE(get<QLabel>("counts")->text(), QString("80.0 points, passed"));
        QCOMPARE(get<QLabel>("machine")->text(), QString("Given by Grace Hopper. The machine's score: 68.4 points."));
        QVERIFY(get<QPushButton>("machineAgain")->isVisible());
        // Every entry has its author, and the entries are in order.
        const QString all = words();
        const auto first = all.indexOf("Here you pressed too hard.");
        const auto second = all.indexOf("gave 80.0 points: The wall is fine by hand.");
        QVERIFY(first > 0 && second > first && all.indexOf("The bur slipped.") > second);
        QVERIFY(all.contains("Grace Hopper, 20/11/2026"));
        AttemptTalk taken = talk();
        taken.overrides.push_back({"Grace Hopper", "2026-11-20T13:00:00Z", {}, "My mistake."});
        m_panel->setTalk(taken);
        QCOMPARE(get<QLabel>("counts")->text(), QString("68.4 points, not passed"));
    }

    void whoMayNotWriteReads()
    {
        m_panel->setTalk(talk());
        m_panel->setMay(false, false);
        QVERIFY(!comment()->isVisible());
        QVERIFY(!reason()->isVisible());
        QVERIFY(words().contains("Here you pressed too hard."));
        m_panel->setTalk({});
        QVERIFY(get<QLabel>("noTalk")->text().contains("What an instructor says"));
    }

    void aCommentThatIsTooLongSaysSoBesideItsField()
    {
        auto* room = get<QLabel>("commentRoom");
        for (const auto& [length, says, isFit] :
             {std::tuple(3000, "", true), std::tuple(3990, "10 more", true), std::tuple(4020, "20 ", false)}) {
            comment()->setPlainText(QString(length, 'w'));
            QCOMPARE(room->isVisible(), length > 3000);
            QVERIFY2(room->text().contains(says), qPrintable(room->text()));
            QCOMPARE(isEnabled("addComment"), isFit);
        }
    }

    void aCommentIsPinned()
    {
        QSignalSpy wanted(m_panel.get(), &CommentsPanel::commentRequested);
        const auto sent = [&] {
            click("addComment");
            return std::tuple(wanted.back()[0].toString(), wanted.back()[1].value<std::optional<std::int64_t>>(),
                              wanted.back()[2].value<std::optional<Place>>());
        };
        const QString words = "Lift the bur here.";
        QVERIFY(!isEnabled("addComment") && !atMoment()->isVisible() && !atPlace()->isVisible());
        comment()->setPlainText("  " + words + ' ');
        m_panel->setMoment(102'400);
        m_panel->setPlace(Place{1.0, 2.0, 3.0});
        QCOMPARE(atMoment()->text(), QString("at 1:42 of the replay"));
        QVERIFY(sent() == std::tuple(words, std::nullopt, std::nullopt));
        m_panel->answer(0, "It could not be kept.");
        atMoment()->setChecked(true);
        atPlace()->setChecked(true);
        const auto pinned = sent();
        QCOMPARE(std::get<1>(pinned), std::optional<std::int64_t>(102'400));
        QCOMPARE(std::get<2>(pinned), std::optional<Place>(Place{1.0, 2.0, 3.0}));
        // The comment was saved: the field is empty for the next one, which begins without pins.
        m_panel->answer(0);
        QVERIFY(comment()->toPlainText().isEmpty());
        QVERIFY(!atPlace()->isChecked() && !atMoment()->isChecked());
        // A place that the writer marks is pinned at once, but not the place of another comment that they look at.
        m_panel->setPlace(Place{1.0, 2.0, 3.0}, true);
        QVERIFY(atPlace()->isChecked());
        m_panel->setPlace(Place{4.0, 5.0, 6.0});
        QVERIFY(!atPlace()->isChecked());
        // A place or moment that others have pinned can be opened.
        m_panel->setTalk(talk());
        QSignalSpy moment(m_panel.get(), &CommentsPanel::momentRequested);
        QSignalSpy place(m_panel.get(), &CommentsPanel::placeRequested);
        pressChips();
        QCOMPARE(moment[0][0].toDouble(), 102.0);
        QCOMPARE(place[0][0].value<Place>(), (Place{1.0, 2.0, 3.0}));
    }

    void aScoreNeedsAReason()
    {
        QSignalSpy wanted(m_panel.get(), &CommentsPanel::overrideRequested);
        QCOMPARE(points()->value(), 68.4);
        points()->setValue(77.7);
        for (const char* typed : {"", "   "}) {
            reason()->setText(typed);
            QVERIFY(!isEnabled("giveScore"));
        }
        reason()->setText("Wall seen by hand");
        click("giveScore");
        QCOMPARE(wanted[0][0].value<std::optional<int>>(), std::optional(777));
        QCOMPARE(wanted[0][1].toString(), QString("Wall seen by hand"));
        // An override that is typed while the previous one is being saved is a new one.
        points()->setValue(60.0);
        m_panel->answer(0);
        QCOMPARE(points()->value(), 60.0);
        QCOMPARE(reason()->text(), QString("Wall seen by hand"));
        m_panel->setTalk(talk());
        click("machineAgain");
        QVERIFY(!wanted[1][0].value<std::optional<int>>());
    }

    void theScoreBeginsWithWhatCounts()
    {
        m_panel->setTalk(talk());
        QCOMPARE(points()->value(), 80.0);
        // An override that is being typed is kept when a new comment arrives.
        points()->setValue(77.7);
        AttemptTalk commented = talk();
        commented.comments.push_back({3, "Grace Hopper", "2026-11-20T14:00:00Z", "Lift the bur here.", {}, {}});
        m_panel->setTalk(commented);
        QCOMPARE(points()->value(), 77.7);
        QVERIFY(!m_panel->unsavedChanges().isEmpty());
        points()->setValue(80.0);
        QVERIFY(m_panel->unsavedChanges().isEmpty());
    }

    /// A comment is kept with its pins, and an override with its points and reason.
    void whatIsTypedStaysWithItsAttempt()
    {
        const auto isEmpty = [&] {
            return comment()->toPlainText().isEmpty() && reason()->text().isEmpty() && points()->value() == 68.4 &&
                   !atMoment()->isChecked() && !atPlace()->isChecked() && !fault()->isVisible();
        };
        m_panel->setAttempt(7);
        m_panel->setMoment(4500);
        m_panel->setPlace(Place{1.0, 2.0, 3.0}, true);
        atMoment()->setChecked(true);
        comment()->setPlainText("Half a sentence");
        reason()->setText("Half a reason");
        points()->setValue(45.5);
        m_panel->refuse("It could not be kept.");
        showAttempt(8);
        QVERIFY(isEmpty());
        comment()->setPlainText("Of another");
        QVERIFY2(m_panel->unsavedChanges().startsWith("2 ") && m_panel->unsavedChanges().contains("\n1 "),
                 qPrintable(m_panel->unsavedChanges()));
        showAttempt(7);
        QCOMPARE(comment()->toPlainText(), QString("Half a sentence"));
        QCOMPARE(reason()->text(), QString("Half a reason"));
        QCOMPARE(points()->value(), 45.5);
        QVERIFY(fault()->isVisible());
        QSignalSpy wanted(m_panel.get(), &CommentsPanel::commentRequested);
        click("addComment");
        QCOMPARE(wanted.size(), 1);
        QCOMPARE(wanted[0][1].value<std::optional<std::int64_t>>(), std::optional<std::int64_t>(4500));
        QVERIFY(wanted[0][2].value<std::optional<Place>>().has_value());
        // After it is discarded, it is gone from all attempts, and a late answer has no effect.
        m_panel->discardChanges();
        m_panel->answer(7, "It could not be kept.");
        QVERIFY(isEmpty() && m_panel->unsavedChanges().isEmpty());
        m_panel->setAttempt(8);
        QVERIFY(isEmpty());
    }

    /// The button is disabled after the comment was saved. A digit that is typed next must not become the score.
    void theKeyboardStaysWithTheComment()
    {
        comment()->setPlainText("Lift the bur here.");
        get<QPushButton>("addComment")->setFocus();
        QTest::keyClick(get<QPushButton>("addComment"), Qt::Key_Space);
        QSignalSpy used(m_panel.get(), &CommentsPanel::formUsed);
        AttemptTalk kept;
        kept.comments.push_back({3, "Grace Hopper", "2026-11-20T14:00:00Z", "Lift the bur here.", {}, {}});
        m_panel->answer(0);
        m_panel->setTalk(kept);
        QVERIFY(m_panel->focusWidget() == comment());
        QVERIFY(!used.isEmpty());
        QVERIFY(used.last().first().value<QWidget*>()->isAncestorOf(comment()));
        QCOMPARE(points()->value(), 68.4);
    }

    void onesOwnCommentIsTakenBackToBeCorrected_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<bool>("leaves");
        QTest::addColumn<bool>("earlier");
        QTest::addColumn<QString>("expected");
        const QString gone = "Here you pressed too hard.";
        QTest::newRow("nothing typed") << QString() << false << false << gone;
        QTest::newRow("below a draft") << "Half a sentence" << false << false << "Half a sentence\n\n" + gone;
        QTest::newRow("another attempt is shown") << QString() << true << false << gone;
        QTest::newRow("taken back elsewhere already") << QString() << false << true << QString();
    }

    void onesOwnCommentIsTakenBackToBeCorrected()
    {
        QFETCH(QString, typed);
        QFETCH(bool, leaves);
        QFETCH(bool, earlier);
        QFETCH(QString, expected);
        AttemptTalk mine = talk();
        mine.comments.front().isMine = true;
        m_panel->setAttempt(7);
        m_panel->setTalk(mine);
        QCOMPARE(m_panel->findChildren<QPushButton*>("takeBack").size(), 1);
        comment()->setPlainText(typed);
        QSignalSpy wanted(m_panel.get(), &CommentsPanel::withdrawRequested);
        get<QPushButton>("takeBack")->setFocus();
        for (int press = 0; press < 2; ++press)  // nothing is sent twice
            QTest::keyClick(get<QPushButton>("takeBack"), Qt::Key_Space);
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted.first().first().toLongLong(), 1);
        if (leaves) {
            m_panel->setAttempt(8);
            m_panel->setTalk({});
        }
        m_panel->withdraw(1, earlier);
        if (leaves) {
            QVERIFY(comment()->toPlainText().isEmpty());
            m_panel->setAttempt(7);
        } else {
            QVERIFY(!words().contains("Here you pressed too hard.") && m_panel->focusWidget() == comment());
            QVERIFY(get<QLabel>("commentSaid")->isVisible());
        }
        QCOMPARE(comment()->toPlainText(), expected);
        QCOMPARE(atMoment()->isChecked(), !earlier);
        QCOMPARE(atPlace()->isChecked(), !earlier);
        // A user who can only read cannot withdraw a comment.
        m_panel->setTalk(mine);
        m_panel->setMay(false, false);
        QVERIFY(get<QPushButton>("takeBack") == nullptr);
    }

    void nothingIsSentTwice()
    {
        auto* add = get<QPushButton>("addComment");
        auto* give = get<QPushButton>("giveScore");
        AttemptTalk mine = talk();
        mine.comments.front().isMine = true;
        m_panel->setTalk(mine);
        comment()->setPlainText("Lift the bur here.");
        reason()->setText("The wall is fine by hand.");
        QSignalSpy comments(m_panel.get(), &CommentsPanel::commentRequested);
        QSignalSpy scores(m_panel.get(), &CommentsPanel::overrideRequested);
        for (int press = 0; press < 3; ++press)
            add->click();
        QVERIFY(comments.size() == 1 && !add->isEnabled());
        comment()->insertPlainText("More. ");
        QVERIFY(!add->isEnabled());
        // A button whose request is pending stays disabled when another request is refused.
        click("takeBack");
        m_panel->keepComment(1, 0, "The school does not answer.");
        QVERIFY(isEnabled("takeBack") && !add->isEnabled());
        QCOMPARE(fault()->text(), QString("The school does not answer."));
        m_panel->answer(0, "It could not be kept.");
        QVERIFY(add->isEnabled() && fault()->isVisible());
        for (int press = 0; press < 3; ++press)
            give->click();
        QVERIFY(scores.size() == 1 && !give->isEnabled() && !isEnabled("machineAgain"));
        QVERIFY(!fault()->isVisible());
        m_panel->answer(0);
        QVERIFY(reason()->text().isEmpty());
    }

    /// If another attempt is shown when the answer arrives, the error is shown when the user returns.
    void whatWasRefusedIsToldAtItsAttempt()
    {
        m_panel->setAttempt(7);
        comment()->setPlainText("Lift the bur here.");
        click("addComment");
        m_panel->setAttempt(8);
        m_panel->answer(7, "It could not be kept.");
        QVERIFY(!fault()->isVisible());
        m_panel->setAttempt(7);
        QVERIFY(fault()->isVisible() && fault()->text() == "It could not be kept.");
        QCOMPARE(comment()->toPlainText(), QString("Lift the bur here."));
        // A comment that is saved meanwhile is not there on return.
        click("addComment");
        m_panel->setAttempt(8);
        m_panel->answer(7);
        QVERIFY(m_panel->unsavedChanges().isEmpty());
        m_panel->setAttempt(7);
        QVERIFY(!fault()->isVisible() && comment()->toPlainText().isEmpty());
    }

    /// Looking at another point or at the replay does not change what the comment is pinned to.
    void whatIsTickedStaysWhatItIs()
    {
        comment()->setPlainText("Half a sentence");
        m_panel->setPlace(Place{1.0, 2.0, 3.0}, true);
        m_panel->setMoment(4157);
        atMoment()->setChecked(true);
        m_panel->setPlace(Place{4.0, 5.0, 6.0});
        QVERIFY(atPlace()->isChecked());
        QCOMPARE(m_panel->place(), std::optional<Place>(Place{1.0, 2.0, 3.0}));
        m_panel->setMoment(1000);
        QCOMPARE(atMoment()->text(), QString("at 0:04 of the replay"));
        atMoment()->setChecked(false);
        QCOMPARE(atMoment()->text(), QString("at 0:01 of the replay"));
        m_panel->setMoment(2000);
        QCOMPARE(atMoment()->text(), QString("at 0:02 of the replay"));
    }

    /// The moment is ticked in the same way as a point that the user clicks.
    void theMomentOneWentToIsTicked()
    {
        const auto goTo = [this](std::int64_t ms) {
            m_panel->hide();
            m_panel->setMoment(0);
            m_panel->setMoment(ms);
            m_panel->show();
        };
        goTo(34'000);
        QVERIFY(atMoment()->isVisible() && !atMoment()->isChecked());  // no comment is being written
        comment()->setPlainText("Here you press too hard");
        goTo(34'000);
        QVERIFY(atMoment()->isChecked());
        QCOMPARE(atMoment()->text(), QString("at 0:34 of the replay"));
        // It stays ticked when the user goes to another moment.
        goTo(70'000);
        QVERIFY(atMoment()->isChecked());
        QCOMPARE(atMoment()->text(), QString("at 0:34 of the replay"));
        // Hiding the panel is not the same as going to a moment, and neither is looking at the pin of another comment.
        atMoment()->setChecked(false);
        m_panel->hide();
        m_panel->show();
        QVERIFY(!atMoment()->isChecked());
        m_panel->setTalk(talk());
        pressChips();
        goTo(102'400);
        QVERIFY(!atMoment()->isChecked());
        goTo(102'400);
        QVERIFY(atMoment()->isChecked());
    }

    /// Point and comma are both accepted as the decimal sign. Otherwise a score typed with the sign of another language
    /// would be ten times as large.
    void aPointAndACommaAreOne()
    {
        const auto back = qScopeGuard([] { QLocale::setDefault(QLocale("en_GB")); });
        for (const char* language : {"en_GB", "de_DE", "es_ES", "ja_JP"})
            for (const char* typed : {"9.5", "9,5"}) {
                QLocale::setDefault(QLocale(QString(language)));
                CommentsPanel panel(nullptr);
                panel.setMay(true, true);
                auto* given = panel.findChild<QDoubleSpinBox*>("givenPoints");
                given->selectAll();
                QTest::keyClicks(given, typed);
                QVERIFY2(given->value() == 9.5, language);
            }
    }

    /// Invalid input stays as it was typed and is not submitted.
    void whatIsNoScoreIsNotMadeOne()
    {
        QSignalSpy wanted(m_panel.get(), &CommentsPanel::overrideRequested);
        reason()->setText("by hand");
        const auto type = [this](const char* keys) {
            points()->selectAll();
            QTest::keyClicks(points(), keys);
        };
        for (const char* typed : {"950", "-5", "100.1"}) {
            type(typed);
            QVERIFY(points()->value() < 0.0 || points()->value() > 100.0);
            QVERIFY(!isEnabled("giveScore"));
            QVERIFY2(get<QLabel>("pointsBeyond")->isVisible(), "nothing is said of it");
            QTest::keyClick(reason(), Qt::Key_Return);
            QCOMPARE(wanted.count(), 0);
        }
        type("100");
        QVERIFY(!get<QLabel>("pointsBeyond")->isVisible());
        click("giveScore");
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted[0][0].value<std::optional<int>>(), std::optional<int>(1000));
    }

private:
    template <typename Widget>
    Widget* get(const char* name) const
    {
        return m_panel->findChild<Widget*>(name);
    }
    [[nodiscard]] QString words() const
    {
        QStringList all;
        for (const QLabel* label : m_panel->findChildren<QLabel*>())
            if (label->isVisible())
                all << label->text();
        return all.join(u'\n');
    }
    void click(const char* button) const { get<QPushButton>(button)->click(); }
    [[nodiscard]] bool isEnabled(const char* button) const { return get<QPushButton>(button)->isEnabled(); }
    [[nodiscard]] QPlainTextEdit* comment() const { return get<QPlainTextEdit>("commentWords"); }
    [[nodiscard]] QLineEdit* reason() const { return get<QLineEdit>("reason"); }
    [[nodiscard]] QDoubleSpinBox* points() const { return get<QDoubleSpinBox>("givenPoints"); }
    [[nodiscard]] QCheckBox* atMoment() const { return get<QCheckBox>("atMoment"); }
    [[nodiscard]] QCheckBox* atPlace() const { return get<QCheckBox>("atPlace"); }
    [[nodiscard]] QLabel* fault() const { return get<QLabel>("fault"); }
    /// Shows an attempt with 68.4 points that has not passed.
    void showAttempt(qint64 id) const
    {
        m_panel->setAttempt(id);
        m_panel->setScore(684, 750, false);
    }
    /// Presses the buttons of comments that lead to their moments and places.
    void pressChips() const
    {
        for (QPushButton* button : m_panel->findChildren<QPushButton*>())
            if (button->property("kind") == "chip")
                button->click();
    }

    std::unique_ptr<CommentsPanel> m_panel;
};

CUSP_TEST(TestTalkPanel)
#include "tst_talk_panel.moc"
