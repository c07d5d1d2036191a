// SPDX-License-Identifier: GPL-3.0-or-later
// The lesson editor: a draft and what it comes to, the page, and the sweep over tolerances.
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
#include "lessons/LessonCatalog.h"
#include "lessons/NewLesson.h"
#include "ui/charts/SaveButton.h"
#include "ui/shell/Actions.h"
#include "ui/study/FormInputs.h"
#include "ui/study/LessonEditor.h"
#include "ui/study/LessonsPage.h"
#include "ui/study/SweepChart.h"

using namespace ui::study;

namespace {

/// A draft is weighed in a tenth of a second; on a machine that has much else to do, in many.
constexpr int kLoadedMs = 60000;

}  // namespace

/// Waits until the draft has been weighed and this is said of it; until this is the answer to what was asked last; and
/// saves.
#define QTRY_CHECKED(part) QTRY_VERIFY2_WITH_TIMEOUT(check().contains(part), qPrintable(check()), kLoadedMs)
#define QTRY_SAID(part) QTRY_VERIFY2_WITH_TIMEOUT(saidBelow().contains(part), qPrintable(saidBelow()), kLoadedMs)
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
        m_actions = new ui::shell::Actions(m_window.get());
        m_editor = new LessonEditor(*m_actions, m_window.get());
        m_window->setCentralWidget(m_editor);
        m_window->resize(1280, 800);
        m_window->show();
    }

    void everyShippedIdealScoresFullOnItself()
    {
        for (const ::lessons::CatalogEntry& entry : ::lessons::readCatalog({})) {
            if (entry.read.lesson->task == ::lessons::Task::RemoveDecay ||
                ::lessons::isExercise(entry.read.lesson->task))
                continue;
            LessonDraft draft;
            draft.begin(entry.read, m_folder->path());
            const auto weighed = weigh(draft.object(), draft.file(), {});
            QVERIFY2(weighed->isFullMarks(), entry.read.lesson->id.c_str());
            QVERIFY2(!weighed->fields.empty(), entry.read.lesson->id.c_str());
            QVERIFY(weighed->band && !weighed->above.outlineMm.isEmpty());
        }
    }

    void aDeeperIdealIsCutDeeper()
    {
        LessonDraft draft;
        draft.begin(shipped("class1-36"), m_folder->path());
        const auto first = weigh(draft.object(), draft.file(), {});
        draft.setSize("depth_mm", 2.0);
        const auto deeper = weigh(draft.object(), draft.file(), first);
        QVERIFY2(deeper->assignment, qPrintable(deeper->read.faults.empty() ? "" : deeper->read.faults[0].sentence()));
        QVERIFY(deeper->assignment->anatomy == first->assignment->anatomy);  // the tooth was not made again
        const auto lowest = [](const Weighed& of) {
            float low = 0.0F;
            for (std::size_t k = 0; k < of.assignment->ideal->parts.size(); ++k)
                if (of.assignment->ideal->parts[k] != core::grading::Part::Keep)
                    low = std::min(low, (*of.assignment->ideal->top)[k]);
            return low;
        };
        QVERIFY2(std::abs(lowest(*first) - lowest(*deeper) - 0.5F) < 0.05F,
                 qPrintable(QStringLiteral("%1 %2").arg(lowest(*first)).arg(lowest(*deeper))));
        QVERIFY(deeper->isFullMarks());
    }

    void aWiderToleranceIsAWiderBand()
    {
        LessonDraft draft;
        draft.begin(shipped("class1-36"), m_folder->path());
        auto weighed = weigh(draft.object(), draft.file(), {});
        const auto mayMm2 = [](const Weighed& of) {
            std::size_t columns = 0;
            for (std::size_t k = 0; k < of.band->deepestMm.size(); ++k)
                columns += of.band->deepestMm[k] < of.band->shallowestMm[k] ? 1 : 0;
            const double cell = of.assignment->anatomy->grid.cellMm;
            return static_cast<double>(columns) * cell * cell;
        };
        double before = 0.0;
        for (const double tolerance : {0.1, 0.3, 0.6, 1.0}) {
            draft.setCriterion(1, "tolerance", tolerance);  // the outline
            weighed = weigh(draft.object(), draft.file(), weighed);
            QVERIFY(mayMm2(*weighed) > before + 0.1);
            before = mayMm2(*weighed);
        }
    }

    void whatIsWrongIsSaidBesideItsField()
    {
        open("class1-36");
        // No bur leaves a line angle of 0.5 mm that has a radius of 0.3 mm.
        spin("bur_radius_mm")->setValue(0.3);
        spin("line_angle_mm")->setValue(0.5);
        QTRY_VERIFY_WITH_TIMEOUT(anyFault("no bur leaves that"), kLoadedMs);
        {
            QTranslator german;
            QVERIFY(german.load(QStringLiteral(":/i18n/cusp_de.qm")));
            QCoreApplication::installTranslator(&german);
            QTRY_VERIFY_WITH_TIMEOUT(!anyFault("no bur"), kLoadedMs);
            QVERIFY2(anyFault("") && !check().contains("no bur"), qPrintable(check()));
        }
        QTRY_VERIFY_WITH_TIMEOUT(anyFault("no bur leaves that"), kLoadedMs);
        QTRY_SAVE("Not saved");
        m_editor->undo();
        QTRY_VERIFY_WITH_TIMEOUT(!anyFault("no bur leaves that"), kLoadedMs);
        QTRY_COMPARE_WITH_TIMEOUT(spin("line_angle_mm")->value(), 0.2, kLoadedMs);
    }

    void aFaultyLessonIsToldOfInTheLanguageOfTheWindow()
    {
        QJsonObject object =
            QJsonDocument::fromJson(QByteArray::fromStdString(shipped("class1-36").lesson->json)).object();
        object.insert("grid", 3);
        object.insert("exam", "maybe");
        object.insert("burs", QJsonArray{"9999"});
        object.insert("minuts", 4);
        object.remove("title");
        const auto read = ::lessons::readDraft(object, m_folder->filePath("odd.lesson.json"));
        QCOMPARE(read.faults.size(), std::size_t{5});
        LessonsPage page(*m_window->findChild<ui::shell::Actions*>(), m_window.get());
        page.setLessons({{read, false, {}}}, {});
        const auto labels = [&page] {
            QStringList all;
            for (const QLabel* label : page.findChildren<QLabel*>())
                all << label->text();
            return all;
        };
        const QString english = read.faults.front().sentence();
        QVERIFY2(labels().contains(english), qPrintable(english));
        {
            QTranslator german;
            QVERIFY(german.load(QStringLiteral(":/i18n/cusp_de.qm")));
            QCoreApplication::installTranslator(&german);
            QTRY_VERIFY(!labels().contains(english));
            for (const ::lessons::Fault& fault : read.faults)
                QVERIFY2(!labels().join(u'\n').contains(fault.english()), qPrintable(fault.english()));
        }
        QTRY_VERIFY(labels().contains(english));
    }

    /// What each key comes to is weighed and shown, but not over what is being typed.
    void aNumberIsTypedKeyByKey()
    {
        open("class1-36");
        QDoubleSpinBox* input = spin("tolerance.depth");
        input->setFocus();
        input->selectAll();
        for (const char* key = "0.45"; *key != '\0'; ++key) {
            QTest::keyClick(input, *key);
            const QString typed = input->text();
            showNumber(*input, input->value());  // as when it has been weighed
            QCOMPARE(input->text(), typed);
        }
        QTest::keyClick(input, Qt::Key_Tab);
        QCOMPARE(input->value(), 0.45);
        showNumber(*input, 0.5);
        QCOMPARE(input->value(), 0.5);
    }

    /// What fails an attempt is called by its limit, in each language with its own decimal sign.
    void aNameTellsTheLimitThatIsSet()
    {
        LessonDraft draft;
        draft.begin(shipped("class1-36"), m_folder->path());
        const QJsonArray criteria = draft.rubric().value("criteria").toArray();
        for (int k = 0; k < criteria.size(); ++k)
            if (criteria.at(k)["id"].toString() == "too_deep") {
                for (const double limit : {2.0, 0.0, 1.5})
                    draft.setCriterion(k, "tolerance", limit);
                const QJsonValue title = draft.rubric().value("criteria").toArray().at(k)["title"];
                QCOMPARE(title["en"].toString(), QString("Floor more than 1.5 mm too deep"));
                QCOMPARE(title["de"].toString(), QString("Boden mehr als 1,5 mm zu tief"));
                // A teacher's own may be a plain text, or none at all.
                for (const QJsonValue& plain : {QJsonValue("Class 1: over 1 mm"), QJsonValue(QJsonValue::Undefined)}) {
                    QJsonObject object = ::lessons::ownVersion(shipped("class1-36"));
                    QJsonObject rubric = draft.rubric();
                    QJsonArray own = criteria;
                    QJsonObject one = own.at(k).toObject();
                    one.remove("title");
                    if (!plain.isUndefined())
                        one.insert("title", plain);
                    own[k] = one;
                    rubric.insert("criteria", own);
                    object.insert("rubric", rubric);
                    LessonDraft changed;
                    changed.begin(::lessons::readDraft(object, m_folder->filePath("mine.lesson.json")),
                                  m_folder->path());
                    changed.setCriterion(k, "tolerance", 2.5);
                    const QJsonValue told = changed.rubric().value("criteria").toArray().at(k)["title"];
                    QCOMPARE(told, plain.isUndefined() ? plain : QJsonValue("Class 1: over 2.5 mm"));
                }
                return;
            }
        QFAIL("there is no such criterion");
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
        QTRY_COMPARE_WITH_TIMEOUT(spin("tolerance.depth")->value(), 0.25, kLoadedMs);
        QCOMPARE(spin("depth_mm")->value(), 1.8);
        m_editor->undo();
        QTRY_COMPARE_WITH_TIMEOUT(spin("depth_mm")->value(), 1.5, kLoadedMs);
        QVERIFY(!m_editor->canUndo());
        m_editor->redo();
        m_editor->redo();
        QTRY_COMPARE_WITH_TIMEOUT(spin("tolerance.depth")->value(), 0.4, kLoadedMs);
        QTRY_COMPARE_WITH_TIMEOUT(spin("depth_mm")->value(), 1.8, kLoadedMs);
    }

    void aShippedLessonIsSavedAsTheTeachersOwn()
    {
        open("class1-36");
        spin("depth_mm")->setValue(1.75);
        spin("tolerance.outline")->setValue(0.35);
        QTRY_CHECKED("100");
        QTRY_SAVE("Saved");
        const QJsonObject object = saved("class1-36-own.lesson.json");
        QCOMPARE(object["based_on"].toString(), QString("ideal-1-class1-1-36.lesson.json"));
        QCOMPARE(object["ideal"].toObject()["sizes"].toObject()["depth_mm"].toDouble(), 1.75);
        const auto read = ::lessons::readLesson(m_folder->filePath("class1-36-own.lesson.json"));
        QVERIFY(read.lesson);
        QVERIFY2(read.faults.empty(), qPrintable(read.faults.empty() ? QString() : read.faults[0].sentence()));
        QCOMPARE(read.lesson->ideal->sizes.at("depth_mm"), 1.75);
        const ::lessons::Rubric before = shipped("class1-36").lesson->rubric;
        for (std::size_t k = 0; k < before.criteria.size(); ++k) {
            const ::lessons::CriterionRule& rule = read.lesson->rubric.criteria.at(k);
            QCOMPARE(rule.tolerance, rule.id == "outline" ? 0.35 : before.criteria[k].tolerance);
        }
        QCOMPARE(read.lesson->rubric.id, std::string("class1-own"));
        QCOMPARE(read.lesson->version, 1);
        // Opened again it is changed where it stands, under a higher version.
        m_editor->edit(read, m_folder->path());
        QTRY_CHECKED("100");
        QTRY_COMPARE_WITH_TIMEOUT(spin("depth_mm")->value(), 1.75, kLoadedMs);
        spin("depth_mm")->setValue(1.6);
        QTRY_SAVE("Saved");
        QCOMPARE(saved("class1-36-own.lesson.json")["version"].toInt(), 2);
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files).size(), 1);
    }

    void saveRefusesNothingSilently()
    {
        open("class1-36");
        weights()[0]->setValue(weights()[0]->value() + 5.0);
        QTRY_VERIFY_WITH_TIMEOUT(anyFault("they must make 100"), kLoadedMs);
        QTRY_SAVE("Not saved: class1-36-own.lesson.json, rubric");
        QVERIFY(QDir(m_folder->path()).isEmpty());
        m_editor->undo();
        // A name that somebody else took meanwhile.
        QFile other(m_folder->filePath("class1-36-own.lesson.json"));
        QVERIFY(other.open(QIODevice::WriteOnly) && other.write("{}") == 2);
        other.close();
        QTRY_SAVE("there is a file class1-36-own.lesson.json already");
        QVERIFY(saved("class1-36-own.lesson.json").isEmpty());
    }

    /// It is shown, and one's own changes come back by a step back, to be saved in its place.
    void whatAnotherHasWrittenIsNotWrittenOver()
    {
        openOwn();
        spin("depth_mm")->setValue(2.0);
        QTRY_SAVE("Saved");
        spin("depth_mm")->setValue(1.5);
        auto* const anew = m_editor->findChild<QPushButton*>("openAnew");
        QVERIFY(!anew->isVisible());
        writeElsewhere("Another's");
        const QJsonObject others = saved("class1-36-own.lesson.json");
        QTRY_SAVE("has been changed since you opened it");
        QCOMPARE(saved("class1-36-own.lesson.json"), others);
        QVERIFY(anew->isVisible());
        anew->click();
        QVERIFY(!anew->isVisible());
        QCOMPARE(m_editor->findChild<QLineEdit*>("draftTitle")->text(), QString("Another's"));
        QTRY_CHECKED("100");
        QTRY_COMPARE_WITH_TIMEOUT(spin("depth_mm")->value(), 2.0, kLoadedMs);
        QVERIFY(m_editor->unsavedFiles().isEmpty());
        m_editor->undo();
        QTRY_COMPARE_WITH_TIMEOUT(spin("depth_mm")->value(), 1.5, kLoadedMs);
        QVERIFY(m_editor->findChild<QLineEdit*>("draftTitle")->text() != "Another's");
        QTRY_SAVE("Saved");
        // Under a version that neither of them had.
        QCOMPARE(saved("class1-36-own.lesson.json")["version"].toInt(), others["version"].toInt() + 1);
        // And once more, over what was written just now.
        spin("depth_mm")->setValue(1.25);
        QTRY_SAVE("Saved");
    }

    void whatAnotherHasWrittenMeanwhileIsSeenAfterACrash()
    {
        openOwn();
        m_editor->setRecoveryFile(m_folder->filePath("unsaved.json"));
        m_editor->recover(m_folder->path());
        spin("depth_mm")->setValue(1.5);
        delete m_editor;
        writeElsewhere("Another's");
        const QJsonObject others = saved("class1-36-own.lesson.json");
        m_window->setCentralWidget(m_editor = recovered().release());
        m_editor->edit(::lessons::readLesson(ownFile()), m_folder->path());
        m_editor->save();
        QTRY_VERIFY2_WITH_TIMEOUT(saidBelow().contains("has been changed since you opened it"), qPrintable(saidBelow()),
                                  kLoadedMs);
        QCOMPARE(saved("class1-36-own.lesson.json"), others);
    }

    /// While the weights do not add up there is no rubric, and yet each input shows what its draft says.
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
        QTRY_VERIFY_WITH_TIMEOUT(anyFault("they must make 100"), kLoadedMs);
        m_editor->undo();
        QTRY_COMPARE_WITH_TIMEOUT(spin("depth_mm")->value(), 1.5, kLoadedMs);
        QVERIFY(anyFault("they must make 100"));
        m_editor->undo();
        QTRY_COMPARE_WITH_TIMEOUT(weights[0]->value(), first, kLoadedMs);
        QTRY_VERIFY_WITH_TIMEOUT(!anyFault("they must make 100"), kLoadedMs);
    }

    void theTitleIsTakenBackAsWell()
    {
        open("class1-36");
        auto* title = m_editor->findChild<QLineEdit*>("draftTitle");
        const QString before = title->text();
        title->setFocus();
        title->clear();
        QTest::keyClicks(title, "Mine");
        m_editor->undo();
        QCOMPARE(title->text(), before);
        m_editor->redo();
        QCOMPARE(title->text(), QString("Mine"));
    }

    /// In one text for all languages, or in none of its own, as "cusp lesson new" writes them.
    void aTitleIsShownHoweverItIsWritten()
    {
        const auto draftOf = [this](const QJsonObject& object) {
            QFile file(m_folder->filePath("mine.lesson.json"));
            if (!file.open(QIODevice::WriteOnly) || file.write(QJsonDocument(object).toJson()) < 0)
                qFatal("cannot write");
            file.close();
            LessonDraft draft;
            draft.begin(::lessons::readDraft(object, file.fileName()), m_folder->path());
            return draft;
        };
        QJsonObject object{{"format", 1}, {"id", "mine"}, {"based_on", "ideal-1-class1-1-36.lesson.json"}};
        LessonDraft inherited = draftOf(object);
        QCOMPARE(inherited.title(), QString("Class I on 36"));
        // Key by key: what nobody has typed in another language says the same, whatever had been made up there.
        LessonDraft own;
        own.begin(shipped("class1-36"), m_folder->path());
        for (LessonDraft* draft : {&inherited, &own}) {
            const auto in = [draft](const char* language) {
                return draft->object().value("title").toObject().value(QLatin1String(language)).toString();
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
        QCOMPARE(plain.object().value("title"), QJsonValue("Yours"));
        QCOMPARE(plain.title(), QString("Yours"));
    }

    /// A lesson whose tooth cannot be made: what is wrong is said, and nothing of another lesson's can be changed in
    /// it.
    void nothingOfTheLessonBeforeIsLeft()
    {
        open("class1-36");
        QFile recording(m_folder->filePath("a.cusprec"));
        const auto assignment = ::lessons::assign(*shipped("class1-36").lesson)->assignment;
        QVERIFY(core::recording::writeRecording(recording.fileName().toStdString(),
                                                core::recording::Recording({}, assignment.anatomy)));
        m_editor->readFolder(m_folder->path());
        const auto* words = m_editor->findChild<QLabel*>("sweepWords");
        QTRY_VERIFY2_WITH_TIMEOUT(words->text().contains("0 of 1 pass"), qPrintable(words->text()), kLoadedMs);
        QFile noise(m_folder->filePath("gone.stl"));
        QVERIFY(noise.open(QIODevice::WriteOnly) && noise.write("no mesh") == 7);
        noise.close();
        ::lessons::ReadLesson scan = shipped("decay-36-small");
        QJsonObject object = QJsonDocument::fromJson(QByteArray::fromStdString(scan.lesson->json)).object();
        object.insert("id", "scan");
        object.insert("tooth", QJsonObject{{"scan", "gone.stl"}, {"fdi", 36}});
        scan = ::lessons::readDraft(object, m_folder->filePath("scan.lesson.json"));
        QVERIFY2(scan.lesson, qPrintable(scan.faults.empty() ? QString() : scan.faults[0].sentence()));
        m_editor->edit(scan, m_folder->path());
        QVERIFY(m_editor->findChild<QDoubleSpinBox*>("depth_mm") == nullptr);
        QVERIFY2(!words->text().contains("pass;"), qPrintable(words->text()));
        QTRY_VERIFY2_WITH_TIMEOUT(check().startsWith(QStringLiteral("⚠ Wrong: scan.lesson.json")), qPrintable(check()),
                                  kLoadedMs);
        QVERIFY(m_editor->findChild<QDoubleSpinBox*>("depth_mm") == nullptr);
        QVERIFY2(anyFault(""), "what is wrong is said");
        QVERIFY(m_editor->findChild<QDoubleSpinBox*>("tolerance.outline") == nullptr);
        QCOMPARE(spin("tolerance.sound_tissue")->value(), 4.0);
    }

    void draftsAreKeptUntilTheyAreDiscarded()
    {
        open("class1-36");
        QVERIFY(m_editor->unsavedChanges().isEmpty());
        spin("depth_mm")->setValue(1.75);
        const QString first = shipped("class1-36").file;
        QCOMPARE(m_editor->unsavedFiles(), QSet<QString>{first});
        open("class1-37");
        spin("tolerance.outline")->setValue(0.35);
        QCOMPARE(m_editor->unsavedFiles().size(), 2);
        // Back at the first, it is as it was left.
        open("class1-36");
        QTRY_COMPARE_WITH_TIMEOUT(spin("depth_mm")->value(), 1.75, kLoadedMs);
        QVERIFY(m_editor->findChild<QLineEdit*>("draftTitle")->text().contains("(own version)"));
        QVERIFY(!m_editor->unsavedChanges().isEmpty());
        m_editor->discardChanges();
        QVERIFY(m_editor->unsavedChanges().isEmpty() && !m_editor->canUndo());
        QVERIFY(!m_editor->findChild<QLineEdit*>("draftTitle")->text().isEmpty());
        QTRY_CHECKED("100");
        QVERIFY(spin("depth_mm")->value() != 1.75);
    }

    void targetsAndSpansAreChanged()
    {
        open("class1-36");
        QVERIFY(!spin("span.outline")->isVisible());
        m_editor->findChild<QCheckBox*>("targetsAndSpans")->click();
        QVERIFY(spin("span.outline")->isVisible() && spin("target.pulp_exposure")->isVisible());
        QVERIFY(m_editor->findChild<QDoubleSpinBox*>("span.pulp_exposure") == nullptr);
        QCOMPARE(spin("span.outline")->value(), 0.7);
        QCOMPARE(spin("target.ridge")->value(), 1.6);
        spin("span.outline")->setValue(1.4);
        spin("target.ridge")->setValue(1.2);
        m_editor->save();
        QTRY_VERIFY2_WITH_TIMEOUT(saidBelow().contains("Saved"), qPrintable(saidBelow()), kLoadedMs);
        const QJsonArray criteria = saved("class1-36-own.lesson.json")["rubric"].toObject()["criteria"].toArray();
        for (const QJsonValue entry : criteria) {
            const QJsonObject criterion = entry.toObject();
            if (criterion["id"] == QStringLiteral("outline"))
                QCOMPARE(criterion["span"].toDouble(), 1.4);
            if (criterion["id"] == QStringLiteral("ridge"))
                QCOMPARE(criterion["target"].toDouble(), 1.2);
        }
        QCOMPARE(criteria.size(), 12);
    }

    /// After a crash.
    void unsavedDraftsComeBack()
    {
        const QString file = m_folder->filePath("unsaved.json");
        m_window->setCentralWidget(m_editor = recovered().release());
        m_editor->edit(shipped("class1-36"), m_folder->path());
        auto* title = m_editor->findChild<QLineEdit*>("draftTitle");
        title->clear();
        QTest::keyClicks(title, "Mine");
        QVERIFY(recovered()->unsavedChanges().isEmpty());  // another window has its own drafts
        delete m_editor;
        QVERIFY(QFile::exists(file));
        // It is the draft of that lesson, and can be undone to what that says.
        m_window->setCentralWidget(m_editor = recovered().release());
        QCOMPARE(m_editor->unsavedFiles(), QSet<QString>{shipped("class1-36").file});
        m_editor->edit(shipped("class1-36"), m_folder->path());
        QCOMPARE(m_editor->findChild<QLineEdit*>("draftTitle")->text(), QString("Mine"));
        m_editor->undo();
        QVERIFY(m_editor->unsavedChanges().isEmpty());
        m_editor->redo();
        m_editor->discardChanges();
        QVERIFY(!QFile::exists(file));
        // Of a lesson that is not there, and of what is no draft, none is made.
        delete m_editor;
        QFile out(file);
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(
            R"([{"from": "gone.lesson.json", "lesson": {"title": "Lost"}}, {"from": ":/lessons/class1-36.lesson.json"}, 7])");
        out.close();
        m_window->setCentralWidget(m_editor = recovered().release());
        QVERIFY(m_editor->unsavedChanges().isEmpty());
    }

    void aFaultyDraftKeepsItsSizes()
    {
        open("class1-36");
        weights()[0]->setValue(weights()[0]->value() + 5.0);
        QTRY_CHECKED("105");
        const auto has = [this](const char* name) { return m_editor->findChild<QDoubleSpinBox*>(name) != nullptr; };
        QTranslator german;
        QVERIFY(german.load(":/i18n/cusp_de"));
        QCoreApplication::installTranslator(&german);
        const auto isGerman = [this] {
            const auto labels = m_editor->findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(),
                               [](const QLabel* label) { return label->text().startsWith("Kostet nichts"); });
        };
        QTRY_VERIFY_WITH_TIMEOUT(isGerman() && has("depth_mm"), kLoadedMs);
        QCoreApplication::removeTranslator(&german);
        open("class1-37");
        m_editor->edit(shipped("class1-36"), m_folder->path());
        QTRY_CHECKED("105");
        QVERIFY(has("depth_mm"));
        // With nothing of it made before.
        LessonDraft draft;
        draft.begin(shipped("class1-36"), m_folder->path());
        draft.setCriterion(1, "weight", 99.0);
        const auto weighed = weigh(draft.object(), draft.file(), {});
        QVERIFY(!weighed->assignment && !weighed->fields.empty());
    }

    void anExerciseHasNoIdealToCheck()
    {
        m_editor->edit(shipped("orientation-2-hold"), m_folder->path());
        QTRY_CHECKED("An exercise has no ideal");
    }

    void aCapturedIdealIsChosenAndUndone()
    {
        const auto assignment = ::lessons::assign(*shipped("class1-36").lesson)->assignment;
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
        QTRY_VERIFY_WITH_TIMEOUT(m_editor->findChild<QDoubleSpinBox*>("depth_mm") == nullptr,
                                 kLoadedMs);  // nothing to set by rule
        QCOMPARE(spin("tolerance.outline")->value(), 0.4);
        QTRY_CHECKED("100.0");
        QTRY_SAVE("Saved");
        const auto read = ::lessons::readLesson(m_folder->filePath("class1-36-own.lesson.json"));
        QVERIFY2(read.lesson && read.lesson->ideal->captured,
                 qPrintable(read.faults.empty() ? QString() : read.faults[0].sentence()));
        m_editor->undo();
        QTRY_VERIFY_WITH_TIMEOUT(m_editor->findChild<QDoubleSpinBox*>("depth_mm") != nullptr, kLoadedMs);
        QTRY_COMPARE_WITH_TIMEOUT(spin("tolerance.outline")->value(), 0.3, kLoadedMs);
    }

    /// A ridge that is thinner than the rubric wants: the ideal would lose points on itself.
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
        const auto assignment = ::lessons::assign(lesson)->assignment;
        std::vector<PastAttempt> attempts;
        for (const float tooDeep : {0.0F, 0.4F, 0.9F}) {
            std::vector<float> top = *assignment.ideal->top;
            for (std::size_t k = 0; k < top.size(); ++k)
                if (assignment.ideal->parts[k] == core::grading::Part::Floor)
                    top[k] -= tooDeep;
            attempts.push_back(
                {QString::number(tooDeep), core::preparation::surfaceHash(*assignment.anatomy), std::move(top), {}});
        }
        PastAttempt other = attempts.front();
        other.surface += 1;
        attempts.push_back(other);
        const auto measured = measureAttempts(assignment, attempts);
        QCOMPARE(measured.size(), std::size_t{3});                // that of another tooth is left out
        const Sweep sweep = sweepOf(lesson.rubric, measured, 0);  // the depth alone
        QCOMPARE(sweep.times.size(), std::size_t{kSweepSteps});
        QCOMPARE(sweep.times.back(), kMostTimes);
        // Each as the rubric's own arithmetic has it: 20 points over 0.75 mm beyond the tolerance.
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
        const auto* words = m_editor->findChild<QLabel*>("sweepWords");
        QTest::keyClick(chart, Qt::Key_Right);
        QCOMPARE(words->text(), chart->words(1.1));
        QCOMPARE(chart->accessibleDescription(), words->text());
        QTest::keyClick(chart, Qt::Key_End);
        QCOMPARE(words->text(), chart->words(3.0));

        const QTemporaryDir folder;
        for (const char* name : {"sweep.png", "sweep.svg", "sweep.csv"})
            QVERIFY2(save->save(folder.filePath(name)), name);
        QCOMPARE(words->text(), QString("Saved: sweep.csv"));
        QFile table(folder.filePath("sweep.csv"));
        QVERIFY(table.open(QIODevice::ReadOnly));
        const QByteArray bytes = table.readAll();
        QVERIFY2(bytes.startsWith("series,Times the tolerance,Points,Recording\r\n"), bytes.constData());
        QCOMPARE(bytes.count("\r\nEach attempt,"), 2 * kSweepSteps);
        QVERIFY(bytes.contains(",b\r\n") && bytes.contains("\r\nMedian,") &&
                bytes.contains("\r\n\"Attempts that pass, %\","));
    }

    /// They would count as failed under every tolerance.
    void attemptsWithoutMeasuresAreLeftOutOfTheSweep()
    {
        open("class1-36");
        const auto* words = m_editor->findChild<QLabel*>("sweepWords");
        m_editor->setKnown({{"a", {}}, {"b", {}}});
        QVERIFY2(words->text().startsWith("Choose a folder") && words->text().contains("2 attempt(s) of the history"),
                 qPrintable(words->text()));
        m_editor->setKnown({{"a", {}}, {"b", {{"depth_mean_mm", 1.5}}}});
        QVERIFY2(words->text().contains("of 1 pass") && words->text().contains("1 attempt(s) of the history"),
                 qPrintable(words->text()));
    }

    void attemptsOfAFolderAreReadAndTheRestIsNamed()
    {
        const auto assignment = ::lessons::assign(*shipped("class1-36").lesson)->assignment;
        for (const QString name : {"a.cusprec", "b.cusprec"})
            QVERIFY(core::recording::writeRecording(m_folder->filePath(name).toStdString(),
                                                    core::recording::Recording({}, assignment.anatomy)));
        QFile noise(m_folder->filePath("noise.cusprec"));
        QVERIFY(noise.open(QIODevice::WriteOnly) && noise.write("hello") == 5);
        noise.close();
        std::atomic<bool> cancel = false;
        int last = 0;
        const PastAttempts past = readAttempts(
            m_folder->path(), [&](int done, int) { last = done; }, cancel);
        QCOMPARE(past.attempts.size(), std::size_t{2});
        QCOMPARE(last, 3);
        QCOMPARE(past.faults.size(), 1);
        QVERIFY2(past.faults[0].contains("noise.cusprec"), qPrintable(past.faults[0]));
        open("class1-36");
        m_editor->readFolder(m_folder->path());
        const auto* words = m_editor->findChild<QLabel*>("sweepWords");
        QTRY_VERIFY2_WITH_TIMEOUT(words->text().contains("0 of 2 pass") && words->text().contains("could not be read"),
                                  qPrintable(words->text()), kLoadedMs);
    }

    void replayingIsCalledOff()
    {
        std::atomic<bool> cancel = true;
        QVERIFY(readAttempts(
                    QStringLiteral(CUSP_SOURCE_DIR "/tests/golden"), [](int, int) {}, cancel)
                    .attempts.empty());
    }

private:
    /// Makes the teacher's own of a lesson, and opens that.
    void openOwn()
    {
        open("class1-36");
        spin("depth_mm")->setValue(1.75);
        QTRY_SAVE("Saved");
        m_editor->edit(::lessons::readLesson(ownFile()), m_folder->path());
        QTRY_CHECKED("100");
        QTRY_COMPARE_WITH_TIMEOUT(spin("depth_mm")->value(), 1.75, kLoadedMs);
    }
    /// Another window's, as long as there is one; else that of the next start.
    std::unique_ptr<LessonEditor> recovered() const
    {
        auto made = std::make_unique<LessonEditor>(*m_actions, nullptr);
        made->setRecoveryFile(m_folder->filePath("unsaved.json"));
        made->recover(m_folder->path());
        return made;
    }
    QString ownFile() const { return m_folder->filePath("class1-36-own.lesson.json"); }
    /// As another window would.
    void writeElsewhere(const QString& title) const
    {
        QJsonObject object = saved("class1-36-own.lesson.json");
        object["title"] = QJsonObject{{"en", title}};
        object["version"] = object["version"].toInt() + 1;
        QFile file(ownFile());
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(QJsonDocument(object).toJson()) > 0);
    }
    ::lessons::ReadLesson shipped(const QString& id) const
    {
        for (const ::lessons::CatalogEntry& entry : ::lessons::readCatalog({}))
            if (entry.read.lesson && QString::fromStdString(entry.read.lesson->id) == id)
                return entry.read;
        qFatal("no such lesson");
        return {};
    }
    void open(const QString& id)
    {
        m_editor->edit(shipped(id), m_folder->path());
        QTRY_CHECKED("100");
    }
    QString check() const { return m_editor->findChild<QLabel*>("selfCheck")->text(); }
    QString saidBelow() const { return m_editor->findChild<QLabel*>("editorSaid")->text(); }
    QDoubleSpinBox* spin(const QString& name) const
    {
        auto* found = m_editor->findChild<QDoubleSpinBox*>(name);
        if (found == nullptr)
            qFatal("no input %s", qPrintable(name));
        return found;
    }
    QList<QDoubleSpinBox*> weights() const
    {
        QList<QDoubleSpinBox*> found;
        for (auto* input : m_editor->findChildren<QDoubleSpinBox*>())
            if (input->accessibleName().startsWith("Weight"))
                found << input;
        return found;
    }
    bool anyFault(const QString& part) const
    {
        for (const QLabel* label : m_editor->findChildren<QLabel*>())
            if (!label->isHidden() && label->text().startsWith(u'⚠') && label->text().contains(part))
                return true;
        return false;
    }
    QJsonObject saved(const QString& name) const
    {
        QFile file(m_folder->filePath(name));
        return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
    }

    std::optional<QTemporaryDir> m_folder;
    std::unique_ptr<QMainWindow> m_window;
    ui::shell::Actions* m_actions = nullptr;
    LessonEditor* m_editor = nullptr;
};

QTEST_MAIN(TestLessonEditor)
#include "tst_lesson_editor.moc"
