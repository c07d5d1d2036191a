// SPDX-License-Identifier: GPL-3.0-or-later
// The lesson editor: a draft and the result of checking it, the page, and the sweep over tolerances.
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>

#include "core/preparation/CapturedIdeal.h"
#include "lessons/NewLesson.h"
#include "tests/support/Checks.h"
#include "tests/support/Files.h"
#include "tests/support/Suite.h"
#include "tests/ui/WindowTest.h"
#include "ui/catalog/LessonsPage.h"
#include "ui/charts/SaveButton.h"
#include "ui/kit/Actions.h"
#include "ui/kit/FormInputs.h"
#include "ui/lessoneditor/LessonEditor.h"
#include "ui/lessoneditor/SweepChart.h"

using namespace ui::kit;
using namespace ui::lessoneditor;
using namespace ui::catalog;
using support::shipped;

namespace {

/// ms; a draft is checked in a tenth of a second, but may take much longer on a busy computer.
constexpr int kLoadedMs = 60000;

QJsonObject jsonOf(const ::lessons::ReadLesson& read)
{
    return QJsonDocument::fromJson(QByteArray::fromStdString(read.lesson->json)).object();
}

QString faultOf(const ::lessons::ReadLesson& read)
{
    return read.faults.empty() ? QString() : read.faults.front().sentence();
}

/// Sets the language of the program to German until the returned object is deleted.
std::unique_ptr<QTranslator> inGerman()
{
    auto german = std::make_unique<QTranslator>();
    if (!german->load(QStringLiteral(":/i18n/cusp_de.qm")))
        qFatal("no German");
    QCoreApplication::installTranslator(german.get());
    return german;
}

}  // namespace

// Each waits until a condition holds: any condition, the result of checking the draft, the value of a number field, the
// message below the form, the message of the sweep. QTRY_SAVE saves the lesson first.
#define QTRY_LOADED(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, kLoadedMs)
#define QTRY_CHECKED(part) QTRY_VERIFY2_WITH_TIMEOUT(check().contains(part), qPrintable(check()), kLoadedMs)
#define QTRY_SHOWS(name, number) QTRY_COMPARE_WITH_TIMEOUT(spin(name)->value(), number, kLoadedMs)
#define QTRY_SAID(part) QTRY_VERIFY2_WITH_TIMEOUT(saidBelow().contains(part), qPrintable(saidBelow()), kLoadedMs)
#define QTRY_SWEPT(part) QTRY_VERIFY2_WITH_TIMEOUT(swept().contains(part), qPrintable(swept()), kLoadedMs)
#define QTRY_SAVE(answer)                                                                                              \
    m_editor->save();                                                                                                  \
    QTRY_SAID(answer)

class TestLessonEditor : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_folder.emplace();
        m_window = std::make_unique<QMainWindow>();
        m_actions = new ui::kit::Actions(m_window.get());
        m_editor = new LessonEditor(*m_actions, m_window.get());
        m_window->setCentralWidget(m_editor);
        m_window->resize(1280, 800);
        m_window->show();
    }

    void aDraftIsWeighed()
    {
        LessonDraft draft = draftOf(shipped("class1-36"));
        const auto first = weigh(draft.object(), draft.file(), {});
        draft.setSize("depth_mm", 2.0);
        auto weighed = weigh(draft.object(), draft.file(), first);
        QVERIFY2(weighed->assignment, qPrintable(faultOf(weighed->read)));
        QVERIFY(weighed->assignment->anatomy == first->assignment->anatomy);  // the tooth was not made again
        const auto lowest = [](const EvaluatedDraft& of) {
            float low = 0.0F;
            for (std::size_t k = 0; k < of.assignment->ideal->parts.size(); ++k)
                if (of.assignment->ideal->parts[k] != core::grading::Part::Keep)
                    low = std::min(low, (*of.assignment->ideal->top)[k]);
            return low;
        };
        QVERIFY(support::near(lowest(*first) - lowest(*weighed), 0.5, 0.05));
        QVERIFY(weighed->isFullMarks() && !weighed->fields.empty() && !weighed->above.outlineMm.isEmpty());
        std::size_t before = 0;
        for (const double tolerance : {0.1, 0.3, 0.6, 1.0}) {
            draft.setCriterion(1, "tolerance", tolerance);  // the criterion of the outline
            weighed = weigh(draft.object(), draft.file(), weighed);
            std::size_t allowed = 0;  // columns that may be cut or left
            for (std::size_t k = 0; k < weighed->band->deepestMm.size(); ++k)
                allowed += weighed->band->deepestMm[k] < weighed->band->shallowestMm[k] ? 1 : 0;
            QVERIFY(allowed > before);
            before = allowed;
        }
    }

    void whatIsWrongIsSaidBesideItsField()
    {
        open("class1-36");
        // A bur with a radius of 0.3 mm cannot leave a line angle of 0.5 mm.
        spin("bur_radius_mm")->setValue(0.3);
        spin("line_angle_mm")->setValue(0.5);
        QTRY_LOADED(anyFault("no bur leaves that"));
        {
            const auto german = inGerman();
            QTRY_LOADED(!anyFault("no bur"));
            QVERIFY2(anyFault("") && !check().contains("no bur"), qPrintable(check()));
        }
        QTRY_LOADED(anyFault("no bur leaves that"));
        QTRY_SAVE("Not saved");
        m_editor->undo();
        QTRY_LOADED(!anyFault("no bur leaves that"));
        QTRY_SHOWS("line_angle_mm", 0.2);
    }

    void aFaultyLessonIsListedInTheLanguageOfTheWindow()
    {
        QJsonObject object = jsonOf(shipped("class1-36"));
        object.insert("grid", 3);
        const auto read = ::lessons::readDraft(object, m_folder->filePath("odd.lesson.json"));
        LessonsPage page(*m_actions, m_window.get());
        page.setLessons({{read, false, {}}}, {});
        const auto shows = [&page](const QString& words) {
            const auto labels = page.findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(),
                               [&words](const QLabel* label) { return label->text() == words; });
        };
        const QString english = faultOf(read);
        QVERIFY2(!english.isEmpty() && shows(english), qPrintable(english));
        auto german = inGerman();
        QTRY_VERIFY(!shows(english));
        german.reset();
        QTRY_VERIFY(shows(english));
    }

    /// The draft is checked and shown after each key, without replacing the text that is being typed.
    void aNumberIsTypedKeyByKey()
    {
        open("class1-36");
        QDoubleSpinBox* input = spin("tolerance.depth");
        input->setFocus();
        input->selectAll();
        for (const char key : {'0', '.', '4', '5'}) {
            QTest::keyClick(input, key);
            const QString typed = input->text();
            showNumber(*input, input->value());  // as after a check of the draft
            QCOMPARE(input->text(), typed);
        }
        QTest::keyClick(input, Qt::Key_Tab);
        QCOMPARE(input->value(), 0.45);
        showNumber(*input, 0.5);
        QCOMPARE(input->value(), 0.5);
    }

    void aTitleTellsTheLimitThatIsSet_data()
    {
        QTest::addColumn<QJsonValue>("title");
        QTest::addColumn<QJsonValue>("changed");
        QTest::newRow("shipped, each language with its own decimal sign")
            << QJsonValue(QJsonObject{{"en", "Floor more than 1 mm too deep"}, {"de", "Boden mehr als 1 mm zu tief"}})
            << QJsonValue(
                   QJsonObject{{"en", "Floor more than 2.5 mm too deep"}, {"de", "Boden mehr als 2,5 mm zu tief"}});
        QTest::newRow("plain text") << QJsonValue("Class 1: over 1 mm") << QJsonValue("Class 1: over 2.5 mm");
        QTest::newRow("none") << QJsonValue(QJsonValue::Undefined) << QJsonValue(QJsonValue::Undefined);
    }
    void aTitleTellsTheLimitThatIsSet()
    {
        QFETCH(QJsonValue, title);
        QFETCH(QJsonValue, changed);
        QJsonObject rubric = draftOf(shipped("class1-36")).rubric();
        QJsonArray criteria = rubric["criteria"].toArray();
        int at = 0;
        while (criteria.at(at)["id"] != QJsonValue("too_deep"))
            ++at;
        QJsonObject criterion = criteria.at(at).toObject();
        criterion.remove("title");
        if (!title.isUndefined())
            criterion.insert("title", title);
        criteria[at] = criterion;
        rubric.insert("criteria", criteria);
        QJsonObject object = ::lessons::ownVersion(shipped("class1-36"));
        object.insert("rubric", rubric);
        LessonDraft draft = draftOf(object);
        for (const double limit : {2.0, 0.0, 2.5})
            draft.setCriterion(at, "tolerance", limit);
        QCOMPARE(draft.rubric()["criteria"].toArray().at(at).toObject().value("title"), changed);
    }

    void changesInARowAreOneStepBack()
    {
        open("class1-36");
        QVERIFY(!m_editor->canUndo());
        for (const double value : {1.6, 1.7, 1.8})
            spin("depth_mm")->setValue(value);
        spin("tolerance.depth")->setValue(0.4);
        QVERIFY(m_editor->canUndo() && !m_editor->canRedo());
        m_editor->undo();
        QTRY_SHOWS("tolerance.depth", 0.2);
        QCOMPARE(spin("depth_mm")->value(), 1.8);
        m_editor->undo();
        QTRY_SHOWS("depth_mm", 1.5);
        QVERIFY(!m_editor->canUndo());
        m_editor->redo();
        m_editor->redo();
        QTRY_SHOWS("tolerance.depth", 0.4);
        QTRY_SHOWS("depth_mm", 1.8);
    }

    void aShippedLessonIsSavedAsTheTeachersOwn()
    {
        open("class1-36");
        spin("depth_mm")->setValue(1.75);
        spin("tolerance.outline")->setValue(0.35);
        QTRY_CHECKED("100");
        QTRY_SAVE("Saved");
        QCOMPARE(saved()["based_on"].toString(), QString("ideal-1-class1-1-36.lesson.json"));
        const auto read = ::lessons::readLesson(ownFile());
        QVERIFY(read.lesson);
        QVERIFY2(read.faults.empty(), qPrintable(faultOf(read)));
        QCOMPARE(read.lesson->ideal->sizes.at("depth_mm"), 1.75);
        const ::lessons::Rubric before = shipped("class1-36").lesson->rubric;
        for (std::size_t k = 0; k < before.criteria.size(); ++k) {
            const ::lessons::CriterionRule& rule = read.lesson->rubric.criteria.at(k);
            QCOMPARE(rule.tolerance, rule.id == "outline" ? 0.35 : before.criteria[k].tolerance);
        }
        QCOMPARE(read.lesson->rubric.id, std::string("class1-own"));
        QCOMPARE(read.lesson->version, 1);
        // When opened again, the lesson is changed in place, with a higher version.
        openOwn();
        spin("depth_mm")->setValue(1.6);
        QTRY_SAVE("Saved");
        QCOMPARE(saved()["version"].toInt(), 2);
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files).size(), 1);
    }

    void saveRefusesNothingSilently()
    {
        open("class1-36");
        weights()[0]->setValue(weights()[0]->value() + 5.0);
        QTRY_LOADED(anyFault("they must make 100"));
        QTRY_SAVE("Not saved: class1-36-own.lesson.json, rubric");
        m_editor->undo();
        const QString before = title()->text();
        typeTitle("");
        QTRY_CHECKED("needs a title");
        QTRY_SAVE("Not saved: The lesson needs a title.");
        QVERIFY(QDir(m_folder->path()).isEmpty());
        m_editor->undo();
        QCOMPARE(title()->text(), before);
        m_editor->redo();
        QVERIFY(title()->text().isEmpty());
        m_editor->undo();
        // Another user has taken the file name meanwhile.
        support::write(ownFile(), "{}");
        QTRY_SAVE("there is a file class1-36-own.lesson.json already");
        QVERIFY(saved().isEmpty());
    }

    /// The other user's version is shown. Undo restores the own changes, which can then be saved over it.
    void whatAnotherHasWrittenIsNotWrittenOver()
    {
        makeOwn();
        spin("depth_mm")->setValue(2.0);
        QTRY_SAVE("Saved");
        spin("depth_mm")->setValue(1.5);
        auto* const anew = m_editor->findChild<QPushButton*>("openAnew");
        QVERIFY(!anew->isVisible());
        const QJsonObject others = writeElsewhere();
        QTRY_SAVE("has been changed since you opened it");
        QCOMPARE(saved(), others);
        QVERIFY(anew->isVisible());
        anew->click();
        QVERIFY(!anew->isVisible());
        QCOMPARE(title()->text(), QString("Another's"));
        QTRY_CHECKED("100");
        QTRY_SHOWS("depth_mm", 2.0);
        QVERIFY(m_editor->unsavedFiles().isEmpty());
        m_editor->undo();
        QTRY_SHOWS("depth_mm", 1.5);
        QVERIFY(title()->text() != "Another's");
        QTRY_SAVE("Saved");
        // The saved version is higher than both.
        QCOMPARE(saved()["version"].toInt(), others["version"].toInt() + 1);
        // Saves again, over the version just saved.
        spin("depth_mm")->setValue(1.75);
        QTRY_SAVE("Saved");
    }

    void whatAnotherHasWrittenMeanwhileIsSeenAfterACrash()
    {
        makeOwn();
        m_editor->recover(m_folder->path(), recoveryFile());
        spin("depth_mm")->setValue(1.5);
        delete m_editor;
        const QJsonObject others = writeElsewhere();
        startAgain();
        m_editor->edit(::lessons::readLesson(ownFile()), m_folder->path());
        QTRY_SAVE("has been changed since you opened it");
        QCOMPARE(saved(), others);
    }

    /// If the weights do not add up there is no rubric. Each field must still show the value of the draft.
    void stepsBackShowNumbersOfARubricThatIsNone()
    {
        open("class1-36");
        const QList<QDoubleSpinBox*> weights = this->weights();
        const double first = weights[0]->value();
        const double second = weights[1]->value();
        weights[0]->setValue(first + 5.0);
        spin("depth_mm")->setValue(1.7);
        weights[1]->setValue(second - 5.0);
        QTRY_CHECKED("100");
        m_editor->undo();
        QTRY_COMPARE_WITH_TIMEOUT(weights[1]->value(), second, kLoadedMs);
        QTRY_LOADED(anyFault("they must make 100"));
        m_editor->undo();
        QTRY_SHOWS("depth_mm", 1.5);
        QVERIFY(anyFault("they must make 100"));
        m_editor->undo();
        QTRY_COMPARE_WITH_TIMEOUT(weights[0]->value(), first, kLoadedMs);
        QTRY_LOADED(!anyFault("they must make 100"));
    }

    /// The title may be one text for all languages, or be missing, as "cusp lesson new" writes it.
    void aTitleIsShownHoweverItIsWritten()
    {
        QJsonObject object{{"format", 1}, {"id", "mine"}, {"based_on", "ideal-1-class1-1-36.lesson.json"}};
        LessonDraft inherited = draftOf(object);
        QCOMPARE(inherited.title(), QString("Class I on 36"));
        // Typed key by key. A language in which nothing was typed gets the same title, whatever it had before.
        LessonDraft own = draftOf(shipped("class1-36"));
        for (LessonDraft* draft : {&inherited, &own}) {
            const auto in = [draft](const char* language) {
                return draft->object()["title"].toObject()[QLatin1String(language)].toString();
            };
            for (const char* typed : {"K", "Kl", "Klausur"})
                draft->setTitle(typed, "de");
            for (const char* language : {"en", "de", "es", "ja"})
                QCOMPARE(in(language), QString("Klausur"));
            draft->setTitle("Midterm", "en");
            draft->setTitle("Die Klausur", "de");
            QCOMPARE(in("en"), QString("Midterm"));
            QCOMPARE(in("de"), QString("Die Klausur"));
            QCOMPARE(in("es"), QString("Die Klausur"));
        }
        object.insert("title", "Mine");
        LessonDraft plain = draftOf(object);
        QCOMPARE(plain.title(), QString("Mine"));
        plain.setTitle("Yours", "de");
        QCOMPARE(plain.object()["title"], QJsonValue("Yours"));
        QCOMPARE(plain.title(), QString("Yours"));
    }

    /// If the tooth of a lesson cannot be made, the editor shows why, and no field of the previous lesson is left in
    /// it.
    void nothingOfTheLessonBeforeIsLeft()
    {
        open("class1-36");
        writeRecording("a.cusprec");
        m_editor->readFolder(m_folder->path());
        QTRY_SWEPT("0 of 1 pass");
        support::write(m_folder->filePath("gone.stl"), "no mesh");
        QJsonObject object = jsonOf(shipped("decay-36-small"));
        object.insert("id", "scan");
        object.insert("tooth", QJsonObject{{"scan", "gone.stl"}, {"fdi", 36}});
        const auto scan = ::lessons::readDraft(object, m_folder->filePath("scan.lesson.json"));
        QVERIFY2(scan.lesson, qPrintable(faultOf(scan)));
        m_editor->edit(scan, m_folder->path());
        QVERIFY(!has("depth_mm"));
        QVERIFY2(!swept().contains("pass;"), qPrintable(swept()));
        QTRY_CHECKED(QStringLiteral("⚠ Wrong: scan.lesson.json"));
        QVERIFY2(anyFault(""), "what is wrong is said");
        QVERIFY(!has("depth_mm") && !has("tolerance.outline"));
        QCOMPARE(spin("tolerance.sound_tissue")->value(), 2.5);
    }

    void draftsAreKeptUntilTheyAreDiscarded()
    {
        open("class1-36");
        QVERIFY(m_editor->unsavedChanges().isEmpty());
        spin("depth_mm")->setValue(1.75);
        QCOMPARE(m_editor->unsavedFiles(), QSet<QString>{shipped("class1-36").file});
        open("class1-37");
        spin("tolerance.outline")->setValue(0.35);
        QCOMPARE(m_editor->unsavedFiles().size(), 2);
        // The first lesson is shown again as it was left.
        open("class1-36");
        QTRY_SHOWS("depth_mm", 1.75);
        QVERIFY(title()->text().contains("(own version)"));
        QVERIFY(!m_editor->unsavedChanges().isEmpty());
        m_editor->discardChanges();
        QVERIFY(m_editor->unsavedChanges().isEmpty() && !m_editor->canUndo());
        QVERIFY(!title()->text().isEmpty());
        QTRY_CHECKED("100");
        QVERIFY(spin("depth_mm")->value() != 1.75);
    }

    void unsavedDraftsComeBackAfterACrash()
    {
        startAgain();
        m_editor->edit(shipped("class1-36"), m_folder->path());
        typeTitle("Mine");
        QVERIFY(recovered()->unsavedChanges().isEmpty());  // another window has its own drafts
        delete m_editor;
        QVERIFY(QFile::exists(recoveryFile()));
        // The recovered draft belongs to that lesson. Undo leads back to the lesson as it is in its file.
        startAgain();
        QCOMPARE(m_editor->unsavedFiles(), QSet<QString>{shipped("class1-36").file});
        m_editor->edit(shipped("class1-36"), m_folder->path());
        QCOMPARE(title()->text(), QString("Mine"));
        m_editor->undo();
        QVERIFY(m_editor->unsavedChanges().isEmpty());
        m_editor->redo();
        // Another user takes the locked window: they do not see the draft, and its owner finds it at their next login.
        m_editor->closeDrafts();
        m_editor->recover(m_folder->path(), m_folder->filePath("others.json"));
        QVERIFY(m_editor->unsavedChanges().isEmpty());
        m_editor->recover(m_folder->path(), recoveryFile());
        m_editor->edit(shipped("class1-36"), m_folder->path());
        QCOMPARE(title()->text(), QString("Mine"));
        m_editor->discardChanges();
        QVERIFY(!QFile::exists(recoveryFile()));
        // A draft is not recovered if its lesson is missing or its content is invalid.
        delete m_editor;
        support::write(recoveryFile(), R"([{"from": "gone.lesson.json", "lesson": {"title": "Lost"}},
                                           {"from": ":/lessons/class1-36.lesson.json"}, 7])");
        startAgain();
        QVERIFY(m_editor->unsavedChanges().isEmpty());
    }

    void aFaultyDraftKeepsItsSizes()
    {
        open("class1-36");
        weights()[0]->setValue(weights()[0]->value() + 5.0);
        QTRY_CHECKED("105");
        open("class1-37");
        m_editor->edit(shipped("class1-36"), m_folder->path());
        QTRY_CHECKED("105");
        QVERIFY(has("depth_mm"));
        // Nothing of it was made before.
        LessonDraft draft = draftOf(shipped("class1-36"));
        draft.setCriterion(1, "weight", 99.0);
        const auto weighed = weigh(draft.object(), draft.file(), {});
        QVERIFY(!weighed->assignment && !weighed->fields.empty());
    }

    void targetsAndSpansAreChanged()
    {
        open("class1-36");
        QVERIFY(!spin("span.outline")->isVisible());
        m_editor->findChild<QCheckBox*>("targetsAndSpans")->click();
        QVERIFY(spin("span.outline")->isVisible() && spin("target.pulp_exposure")->isVisible());
        QVERIFY(!has("span.pulp_exposure"));
        QCOMPARE(spin("span.outline")->value(), 0.4);
        QCOMPARE(spin("target.ridge")->value(), 2.0);
        spin("span.outline")->setValue(1.4);
        spin("target.ridge")->setValue(1.2);
        QTRY_SAVE("Saved");
        QMap<QString, QJsonObject> criteria;
        for (const QJsonValue criterion : saved()["rubric"].toObject()["criteria"].toArray())
            criteria.insert(criterion["id"].toString(), criterion.toObject());
        QCOMPARE(criteria.size(), static_cast<qsizetype>(shipped("class1-36").lesson->rubric.criteria.size()));
        QCOMPARE(criteria["outline"]["span"].toDouble(), 1.4);
        QCOMPARE(criteria["ridge"]["target"].toDouble(), 1.2);
    }

    void anExerciseHasNoIdealToCheck()
    {
        m_editor->edit(shipped("orientation-2-hold"), m_folder->path());
        QTRY_CHECKED("An exercise has no ideal");
    }

    void aCapturedIdealIsChosenAndUndone()
    {
        const auto assignment = support::assigned("class1-36");
        std::vector<float> top = *assignment.ideal->top;
        for (std::size_t k = 0; k < top.size(); ++k)
            if (assignment.ideal->parts[k] != core::grading::Part::Keep)
                top[k] -= 0.3F;
        const core::terrain::Tooth cut = core::terrain::restored(assignment.anatomy, top);
        const core::terrain::Tooth* const one = &cut;
        const auto ideal = core::preparation::capture(std::span(&one, 1), {0.4, 0.5, 8.0, 0.2}, {"mine"});
        QVERIFY(core::preparation::writeCaptured(m_folder->filePath("mine.cuspideal").toStdString(), *ideal));
        open("class1-36");
        auto* reference = m_editor->findChild<QComboBox*>("reference");
        QTRY_COMPARE_WITH_TIMEOUT(reference->count(), 2, kLoadedMs);
        reference->setCurrentIndex(1);
        emit reference->activated(1);
        QTRY_LOADED(!has("depth_mm"));  // no rule to adjust
        QCOMPARE(spin("tolerance.outline")->value(), 0.4);
        QTRY_CHECKED("100.0");
        QTRY_SAVE("Saved");
        const auto read = ::lessons::readLesson(ownFile());
        QVERIFY2(read.lesson && read.lesson->ideal->captured, qPrintable(faultOf(read)));
        m_editor->undo();
        QTRY_LOADED(has("depth_mm"));
        QTRY_SHOWS("tolerance.outline", 0.2);
    }

    /// The ridge is thinner than the rubric requires, so the ideal itself would lose points.
    void fitWidensToWhatTheIdealNeeds()
    {
        open("class1-36");
        spin("ridge_mm")->setValue(0.9);
        QTRY_CHECKED("only");
        QTRY_SAVE("whoever cuts exactly this ideal would lose points");
        for (auto* button : m_editor->findChildren<QPushButton*>())
            if (button->accessibleName().startsWith("Fit"))
                button->click();
        QTRY_CHECKED("scores 100");
        QTRY_SAVE("Saved");
    }

    void sweepMarksEachAttemptUnderEachTolerance()
    {
        const ::lessons::Lesson lesson = *shipped("class1-36").lesson;
        const auto assignment = support::assigned("class1-36");
        std::vector<PastAttempt> attempts;
        for (const float tooDeep : {0.0F, 0.4F, 0.55F}) {
            std::vector<float> top = *assignment.ideal->top;
            for (std::size_t k = 0; k < top.size(); ++k)
                if (assignment.ideal->parts[k] == core::grading::Part::Floor)
                    top[k] -= tooDeep;
            attempts.push_back(
                {QString::number(tooDeep), core::preparation::surfaceHash(*assignment.anatomy), std::move(top), {}});
        }
        attempts.push_back(attempts.front());
        attempts.back().surface += 1;
        const auto measured = measureAttempts(assignment, attempts);
        QCOMPARE(measured.size(), std::size_t{3});                // one of another tooth is left out
        const Sweep sweep = sweepOf(lesson.rubric, measured, 0);  // of the depth alone
        QCOMPARE(sweep.times.size(), std::size_t{kSweepSteps});
        QCOMPARE(sweep.times.back(), kMostTimes);
        for (std::size_t step = 0; step < sweep.times.size(); ++step) {
            ::lessons::Rubric rubric = lesson.rubric;
            rubric.criteria[0].tolerance *= sweep.times[step];
            int passed = 0;
            for (std::size_t k = 0; k < measured.size(); ++k) {
                const auto sheet = ::lessons::grade(rubric, measured[k].values);
                QCOMPARE(sweep.lines[k].tenths[step], sheet.totalTenths);
                passed += sheet.passed() ? 1 : 0;
                if (step > 0)
                    QVERIFY(sweep.lines[k].tenths[step] >= sweep.lines[k].tenths[step - 1]);
            }
            QCOMPARE(sweep.passed[step], passed);
        }
        QCOMPARE(sweep.lines[0].tenths[sweep.stepOf(1.0)], ::lessons::kFullTenths);
        QVERIFY(sweep.lines[2].tenths.back() > sweep.lines[2].tenths.front());
        SweepChart chart(nullptr);
        chart.setSweep(sweep);
        QVERIFY2(chart.words(1.0).contains("of 3 pass"), qPrintable(chart.words(1.0)));
    }

    void theSweepIsSavedAndWalkedWithKeys()
    {
        open("class1-36");
        auto* chart = m_editor->findChild<SweepChart*>();
        auto* save = chart->findChild<ui::charts::SaveButton*>();
        QVERIFY(save->isHidden());
        m_editor->setKnown({{"a", {{"depth_mean_mm", 1.5}}}, {"b", {{"depth_mean_mm", 2.0}}}});
        QVERIFY(!save->isHidden());
        QVERIFY(!save->accessibleName().isEmpty() && (save->focusPolicy() & Qt::TabFocus) != 0);
        QTest::keyClick(chart, Qt::Key_Right);
        QCOMPARE(swept(), chart->words(1.1));
        QCOMPARE(chart->accessibleDescription(), swept());
        QTest::keyClick(chart, Qt::Key_End);
        QCOMPARE(swept(), chart->words(3.0));
        for (const char* name : {"sweep.png", "sweep.svg", "sweep.csv"})
            QVERIFY2(save->save(m_folder->filePath(name)), name);
        QCOMPARE(swept(), QString("Saved: sweep.csv"));
        const auto table = QByteArray::fromStdString(support::bytesOf(m_folder->filePath("sweep.csv").toStdString()));
        QVERIFY2(table.startsWith("series,Times the tolerance,Points,Recording\r\n"), table.constData());
        QCOMPARE(table.count("\r\nEach attempt,"), 2 * kSweepSteps);
        for (const char* part : {",b\r\n", "\r\nMedian,", "\r\n\"Attempts that pass, %\","})
            QVERIFY2(table.contains(part), part);
    }

    /// Attempts without measures would count as failed under every tolerance.
    void attemptsWithoutMeasuresAreLeftOutOfTheSweep()
    {
        open("class1-36");
        m_editor->setKnown({{"a", {}}, {"b", {}}});
        QVERIFY2(swept().startsWith("Choose a folder") && swept().contains("2 attempt(s) of the history"),
                 qPrintable(swept()));
        m_editor->setKnown({{"a", {}}, {"b", {{"depth_mean_mm", 1.5}}}});
        QVERIFY2(swept().contains("of 1 pass") && swept().contains("1 attempt(s) of the history"), qPrintable(swept()));
    }

    void attemptsOfAFolderAreReadAndTheRestIsNamed()
    {
        for (const char* name : {"a.cusprec", "b.cusprec"})
            writeRecording(name);
        support::write(m_folder->filePath("noise.cusprec"), "hello");
        std::atomic<bool> cancel = false;
        int last = 0;
        const auto read = [&] {
            return readAttempts(
                m_folder->path(), [&](int done, int) { last = done; }, cancel);
        };
        const PastAttempts past = read();
        QCOMPARE(past.attempts.size(), std::size_t{2});
        QCOMPARE(last, 3);
        QCOMPARE(past.faults.size(), 1);
        QVERIFY2(past.faults[0].contains("noise.cusprec"), qPrintable(past.faults[0]));
        cancel = true;
        QVERIFY(read().attempts.empty());
        open("class1-36");
        m_editor->readFolder(m_folder->path());
        QTRY_SWEPT("could not be read");
        QVERIFY2(swept().contains("0 of 2 pass"), qPrintable(swept()));
    }

private:
    [[nodiscard]] QString ownFile() const { return m_folder->filePath("class1-36-own.lesson.json"); }
    [[nodiscard]] QString recoveryFile() const { return m_folder->filePath("unsaved.json"); }
    /// Returns the teacher's own version of the lesson from its file.
    [[nodiscard]] QJsonObject saved() const
    {
        const std::string bytes = support::bytesOf(ownFile().toStdString());
        return QJsonDocument::fromJson(QByteArray::fromStdString(bytes)).object();
    }
    void open(const std::string& id)
    {
        m_editor->edit(shipped(id), m_folder->path());
        QTRY_CHECKED("100");
    }
    void openOwn()
    {
        m_editor->edit(::lessons::readLesson(ownFile()), m_folder->path());
        QTRY_CHECKED("100");
        QTRY_SHOWS("depth_mm", 1.75);
    }
    /// Saves a teacher's own version of a lesson and opens it.
    void makeOwn()
    {
        open("class1-36");
        spin("depth_mm")->setValue(1.75);
        QTRY_SAVE("Saved");
        openOwn();
    }
    /// Returns an editor that has recovered the drafts: another window's editor while this one exists, otherwise that
    /// of the next start.
    std::unique_ptr<LessonEditor> recovered() const
    {
        auto made = std::make_unique<LessonEditor>(*m_actions, nullptr);
        made->recover(m_folder->path(), recoveryFile());
        return made;
    }
    void startAgain()
    {
        m_editor = recovered().release();
        m_window->setCentralWidget(m_editor);
    }
    /// Saves another title and a higher version, as another window would. Returns the new content of the file.
    QJsonObject writeElsewhere() const
    {
        QJsonObject object = saved();
        object["title"] = QJsonObject{{"en", "Another's"}};
        object["version"] = object["version"].toInt() + 1;
        support::write(ownFile(), QJsonDocument(object).toJson().toStdString());
        return object;
    }
    void writeRecording(const char* name) const
    {
        QVERIFY(
            core::recording::writeRecording(m_folder->filePath(name).toStdString(),
                                            core::recording::Recording({}, support::assigned("class1-36").anatomy)));
    }
    [[nodiscard]] LessonDraft draftOf(const ::lessons::ReadLesson& read) const
    {
        LessonDraft draft;
        draft.begin(read, m_folder->path());
        return draft;
    }
    [[nodiscard]] LessonDraft draftOf(const QJsonObject& object) const
    {
        const QString file = m_folder->filePath("mine.lesson.json");
        support::write(file, QJsonDocument(object).toJson().toStdString());
        return draftOf(::lessons::readDraft(object, file));
    }
    [[nodiscard]] QString textOf(const char* label) const { return m_editor->findChild<QLabel*>(label)->text(); }
    [[nodiscard]] QString check() const { return textOf("selfCheck"); }
    [[nodiscard]] QString saidBelow() const { return textOf("editorSaid"); }
    [[nodiscard]] QString swept() const { return textOf("sweepWords"); }
    [[nodiscard]] QLineEdit* title() const { return m_editor->findChild<QLineEdit*>("draftTitle"); }
    void typeTitle(const QString& words) const
    {
        title()->setFocus();
        title()->selectAll();
        QTest::keyClick(title(), Qt::Key_Delete);
        QTest::keyClicks(title(), words);
    }
    [[nodiscard]] bool has(const char* name) const { return m_editor->findChild<QDoubleSpinBox*>(name) != nullptr; }
    [[nodiscard]] QDoubleSpinBox* spin(const char* name) const
    {
        if (!has(name))
            qFatal("no input %s", name);
        return m_editor->findChild<QDoubleSpinBox*>(name);
    }
    [[nodiscard]] QList<QDoubleSpinBox*> weights() const
    {
        QList<QDoubleSpinBox*> found = m_editor->findChildren<QDoubleSpinBox*>();
        found.removeIf([](const auto* input) { return !input->accessibleName().startsWith("Weight"); });
        return found;
    }
    [[nodiscard]] bool anyFault(const QString& part) const
    {
        const auto labels = m_editor->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&part](const QLabel* label) {
            return !label->isHidden() && label->text().startsWith(u'⚠') && label->text().contains(part);
        });
    }

    std::optional<QTemporaryDir> m_folder;
    std::unique_ptr<QMainWindow> m_window;
    ui::kit::Actions* m_actions = nullptr;
    LessonEditor* m_editor = nullptr;
};

CUSP_TEST(TestLessonEditor)
#include "tst_lesson_editor.moc"
