// SPDX-License-Identifier: GPL-3.0-or-later
// The strip above the tooth: a lesson's steps and hints, and what a screen reader reads of them.
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "tests/support/Suite.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/practice/LessonStrip.h"

using ui::practice::LessonStrip;

namespace {

::lessons::Lesson threeSteps()
{
    ::lessons::Lesson lesson;
    lesson.goal = {{"en", "The goal"}};
    for (const std::string step : {"First", "Second", "Third"})
        lesson.steps.push_back({{{"en", step}}, {{"en", step + " hint"}}});
    lesson.steps[1].hint.clear();
    return lesson;
}

}  // namespace

class TestLessonStrip : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        QLocale::setDefault(QLocale("en_GB"));
        m_strip = std::make_unique<LessonStrip>(nullptr);
        m_strip->setLesson(threeSteps());
        m_strip->show();
        m_strip->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_strip.get()));
    }

    void cleanup() { m_strip.reset(); }

    void itGoesOnByItselfWhereTheProgramKnows()
    {
        using core::terrain::Material;
        lessons::Lesson lesson = threeSteps();
        lesson.steps[0].doneWhen = lessons::Reached::DecayFound;
        lesson.steps[1].doneWhen = lessons::Reached::Junction;
        m_strip->setLesson(lesson);
        const core::terrain::PerMaterial whole{10.0, 10.0, 10.0, 10.0};
        core::terrain::PerMaterial removed{};
        removed[static_cast<std::size_t>(Material::Dentin)] = 1.0;
        m_strip->follow(whole, removed, false);
        QCOMPARE(words(), QString("First"));
        removed[static_cast<std::size_t>(Material::Caries)] = 1.0;
        m_strip->follow(whole, removed, false);
        QCOMPARE(words(), QString("Third"));
        // If the student goes back, the strip stays there until a new step is reached.
        arrow("Previous step").click();
        m_strip->follow(whole, removed, false);
        QCOMPARE(words(), QString("Second"));
    }

    void eachDepthIsReachedAnew()
    {
        lessons::Lesson lesson = threeSteps();
        lesson.steps[0].doneWhen = lesson.steps[1].doneWhen = lessons::Reached::Depth;
        m_strip->setLesson(lesson);
        for (const char* next : {"Second", "Third"}) {
            m_strip->follow({}, {}, false);
            for (int pictures = 0; pictures < 2; ++pictures) {
                m_strip->follow({}, {}, true);
                QCOMPARE(words(), QString(next));
            }
        }
    }

    void practiceSaysWhatToDo()
    {
        using core::terrain::Material;
        core::terrain::PerMaterial whole{};
        core::terrain::PerMaterial removed{};
        const auto decay = static_cast<std::size_t>(Material::Caries);
        whole[decay] = 10.0;
        m_strip->setPractice();
        const QString first = words();
        QVERIFY(first.contains("decay"));
        removed[decay] = 5.0;
        m_strip->follow(whole, removed, false);
        QCOMPARE(words(), first);
        removed[decay] = 9.95;
        m_strip->follow(whole, removed, false);
        QVERIFY(words() != first);
    }

    void aLongStepIsNoHigherThanAShortOne()
    {
        lessons::Lesson lesson = threeSteps();
        lesson.steps[1].text = {{"en", std::string(30, 'a').append(1, ' ').append(30, 'b')}};
        lesson.steps[1].hint = lesson.steps[0].hint;
        m_strip->setLesson(lesson);
        const int widthPx = m_strip->sizeHint().width() + 150;
        const int heightPx = m_strip->heightForWidth(widthPx);
        arrow("Next step").click();
        QVERIFY2(m_strip->findChild<QLabel*>("lessonStep")->sizeHint().width() > 150, "the words need two lines");
        QCOMPARE(m_strip->heightForWidth(widthPx), heightPx);
    }

    void aHintIsForWhoAsks()
    {
        QCOMPARE(words(), QString("First"));
        hint().click();
        QCOMPARE(words(), QString("First hint"));
        arrow("Next step").click();
        QCOMPARE(words(), QString("Second"));
        QVERIFY(!hint().isVisible());
        arrow("Next step").click();
        QCOMPARE(words(), QString("Third"));
        QVERIFY(hint().isVisible() && !hint().isChecked());
        hint().click();
        QCOMPARE(words(), QString("Third hint"));
        hint().click();
        QCOMPARE(words(), QString("Third"));
        hint().click();
        m_strip->setLesson(threeSteps());
        QCOMPARE(words(), QString("First"));
        QVERIFY(!hint().isChecked());
    }

    /// A screen reader (AT-SPI) reads the description of the focused control when it changes.
    void theKeysStayWithTheStrip()
    {
        const auto press = [](QWidget& control) {
            control.setFocus();
            QTest::keyClick(&control, Qt::Key_Space);
            return control.accessibleDescription();
        };
        QCOMPARE(press(hint()), QString("First hint"));
        QCOMPARE(press(hint()), QString("First"));
        QCOMPARE(press(arrow("Next step")), QString("Second"));
        press(arrow("Next step"));
        QCOMPARE(words(), QString("Third"));
        QVERIFY(arrow("Previous step").hasFocus());
        press(arrow("Previous step"));
        press(arrow("Previous step"));
        QCOMPARE(words(), QString("First"));
        QVERIFY(arrow("Next step").hasFocus());
    }

    void anExamThatIsOverSaysSo()
    {
        ::lessons::Lesson exam = threeSteps();
        exam.exam = true;
        exam.minutes = 1.0;
        m_strip->setLesson(exam);
        const auto* time = m_strip->findChild<ui::kit::TabularDigitsLabel*>("lessonTime");
        m_strip->setTime(60.5);
        QCOMPARE(time->text(), QString("0:00"));
        m_strip->conclude(LessonStrip::Ending::WithScore);
        QVERIFY(words().contains("The exam is over"));
        QVERIFY(!hint().isVisible() && !arrow("Next step").isVisible());
        m_strip->setTime(70.0);
        QCOMPARE(time->text(), QString("0:00"));
        // The strip mentions another attempt only when the exam is graded and an attempt is left.
        QVERIFY(!words().contains("another attempt"));
        m_strip->setMayBeginAgain(true);
        QVERIFY(words().contains("The exam is over") && words().contains("another attempt"));
        m_strip->setMayBeginAgain(false);
        // Another attempt begins like the first.
        m_strip->setLesson(exam);
        QCOMPARE(words(), QString("First"));
        m_strip->setTime(10.0);
        QCOMPARE(time->text(), QString("0:50"));
    }

private:
    QString words() const { return m_strip->findChild<QLabel*>("lessonStep")->text(); }
    QPushButton& hint() const { return *m_strip->findChild<QPushButton*>("lessonHint"); }
    QToolButton& arrow(const QString& name) const
    {
        for (auto* button : m_strip->findChildren<QToolButton*>())
            if (button->accessibleName() == name)
                return *button;
        qFatal("no such arrow");
        return *m_strip->findChild<QToolButton*>();
    }

    std::unique_ptr<LessonStrip> m_strip;
};

CUSP_TEST(TestLessonStrip)
#include "tst_lesson_strip.moc"
