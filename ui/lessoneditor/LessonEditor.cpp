// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessoneditor/LessonEditor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QButtonGroup>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSaveFile>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "core/base/WholeFile.h"
#include "lessons/IdealFromRecordings.h"
#include "ui/kit/Actions.h"
#include "ui/kit/FileDialog.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/PrivateFile.h"
#include "ui/kit/ScrollPane.h"
#include "ui/kit/StandardFolders.h"
#include "ui/kit/Theme.h"
#include "ui/lessoneditor/DraftEvaluator.h"
#include "ui/lessoneditor/IdealForm.h"
#include "ui/lessoneditor/RubricForm.h"
#include "ui/lessoneditor/SweepPage.h"
#include "ui/lessoneditor/ToleranceView.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/LessonTexts.h"
#include "ui/text/Texts.h"
#include "ui/text/ValidationTexts.h"

namespace ui::lessoneditor {
namespace {

using namespace ui::kit;

constexpr int kFormWidthPx = 430;
constexpr int kNarrowFormPx = 360;
constexpr int kKeepMs = 5000;  ///< interval of saving drafts; a crash loses the changes since then
constexpr qint64 kLargestRecovery = qint64{16} << 20;
constexpr const char* kRecordings = "*.cusprec";
constexpr const char* kIdeals = "*.cuspideal";

std::filesystem::path toPath(const QString& file)
{
    return {file.toStdU16String()};
}

/// Returns the text of a validation issue. An empty title has no position in the file, so it has a text of its own.
QString wordsOf(const ::lessons::ValidationIssue& fault, const LessonDraft& draft)
{
    return fault.key == QStringLiteral("title") && draft.title().isEmpty()
               ? LessonEditor::tr("The lesson needs a title.")
               : text::faultWords(fault);
}

/// Writes a draft to its file. Returns an empty string, or the error message.
/// @param weighed  evaluation of the draft
QString write(LessonDraft& draft, const EvaluatedDraft& weighed)
{
    if (draft.isOvertaken())
        return LessonEditor::tr("Not saved: %1 has been changed since you opened it, in another window or at another "
                                "computer. Open it anew to see that; a step back then brings your own changes back, "
                                "to be saved in its place.")
            .arg(QFileInfo(draft.file()).fileName());
    for (const ::lessons::ValidationIssue& fault : weighed.read.faults)
        if (fault.grave)
            return LessonEditor::tr("Not saved: %1").arg(wordsOf(fault, draft));
    if (weighed.itself && !weighed.isFullMarks())
        return LessonEditor::tr("Not saved: whoever cuts exactly this ideal would lose points. Widen the tolerances "
                                "that are named, or press Fit.");
    const QString file = draft.file();
    if (!draft.isSavedOnce() && QFileInfo::exists(file))
        return LessonEditor::tr("Not saved: there is a file %1 already. Open that lesson instead.")
            .arg(QFileInfo(file).fileName());
    QDir().mkpath(QFileInfo(file).absolutePath());
    // Marks the draft as saved only after its file has been written.
    LessonDraft written = draft;
    const QByteArray json = written.stamped();
    if (const core::Status done =
            core::writeWhole(toPath(file), {json.constData(), static_cast<std::size_t>(json.size())}, "The lesson");
        !done)
        return LessonEditor::tr("Not saved: %1").arg(QString::fromStdString(done.error().detail));
    draft = written;
    return {};
}

}  // namespace

LessonEditor::LessonEditor(const Actions& actions, QWidget* parent)
    : Page(actions, parent), m_weigher(new DraftEvaluator(this))
{
    removeGuestSign();
    m_capturing.setMaxThreadCount(1);
    connect(m_weigher, &DraftEvaluator::weighed, this, &LessonEditor::take);
    connect(&m_keeping, &QTimer::timeout, this, &LessonEditor::keepDrafts);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace4);
    auto* form = new ScrollPane(makeForm(), QPalette::Window, this);
    form->setMinimumWidth(kNarrowFormPx);
    form->setMaximumWidth(kFormWidthPx);
    row->addWidget(form, 2);
    row->addWidget(makePictures(), 3);
    body()->addLayout(row, 1);
    body()->addWidget(makeFoot(actions));
    text::bindTranslation(this, [this] { retranslateUi(); });
}

/// Recreates the inputs and evaluates the draft again, because both contain text in the previous language.
void LessonEditor::retranslateUi()
{
    if (m_present.isEmpty()) {
        setTitle(tr("Lesson editor"));
        return;
    }
    const ::lessons::Lesson& lesson = m_opened.at(m_present).lesson;
    showTitle();
    m_ideal->forgetWords();
    m_ideal->begin(lesson.task);
    m_rubric->forgetWords();
    m_rubric->offerCriteria(lesson.rubric.criteria);
    m_rubric->showValues(draft().rubric());
    offerReferences();
    if (m_good)
        showMeaning();
    if (m_saying) {
        const bool mayOpenAnew = !m_anew->isHidden();
        say(m_saying, m_isSaidWrong);
        m_anew->setVisible(mayOpenAnew);
    }
    m_weigher->weigh(draft().object(), draft().file());
}

LessonEditor::~LessonEditor()
{
    keepDrafts();
    m_capturing.waitForDone();
}

void LessonEditor::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    m_title->setFocus();
}

LessonDraft& LessonEditor::draft()
{
    return m_opened.at(m_present).draft;
}

const LessonDraft& LessonEditor::draft() const
{
    return m_opened.at(m_present).draft;
}

QWidget* LessonEditor::makeForm()
{
    auto* form = new QWidget(this);
    auto* column = new QVBoxLayout(form);
    column->setContentsMargins(kSpace4, 0, kSpace4, kSpace2);
    column->setSpacing(kSpace2);
    m_title = new QLineEdit(form);
    text::bindTranslation(m_title, [this] { m_title->setAccessibleName(tr("Title of the lesson")); });
    m_title->setObjectName(QStringLiteral("draftTitle"));
    kit::bindToForm(m_title);
    connect(m_title, &QLineEdit::textEdited, this, [this](const QString& title) {
        draft().setTitle(title, QLocale().name().section(u'_', 0, 0));
        setTitle(tr("Lesson editor: %1").arg(title));
        changed();
    });
    column->addWidget(m_title);
    m_generalFault = kit::faultLabel(form);
    column->addWidget(m_generalFault);
    column->addSpacing(kSpace2);
    m_ideal = new IdealForm(form);
    connect(m_ideal, &IdealForm::sizeSet, this, [this](const QString& id, double value) {
        draft().setSize(id, value);
        changed();
    });
    connect(m_ideal, &IdealForm::referenceChosen, this, &LessonEditor::chooseReference);
    connect(m_ideal, &IdealForm::recordingsRequested, this, &LessonEditor::askForRecordings);
    column->addWidget(m_ideal);
    column->addSpacing(kSpace2);
    m_rubric = new RubricForm(form);
    connect(m_rubric, &RubricForm::criterionSet, this, [this](int index, const char* key, double value) {
        draft().setCriterion(index, key, value);
        changed();
    });
    connect(m_rubric, &RubricForm::passMarkSet, this, [this](double points) {
        draft().setPassMark(points);
        changed();
    });
    column->addWidget(m_rubric);
    column->addStretch(1);
    return form;
}

QWidget* LessonEditor::makePictures()
{
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace2);
    auto* choices = new QHBoxLayout;
    choices->setSpacing(kSpace1);
    auto* group = new QButtonGroup(side);
    auto* pictures = new QStackedWidget(side);
    const auto add = [&](const char* name, const char* tip, QWidget* page) {
        auto* button = new QPushButton(side);
        button->setProperty("kind", "segment");
        button->setCheckable(true);
        button->setAutoDefault(true);
        text::bindTranslation(button, [button, name, tip] {
            button->setText(tr(name));
            button->setToolTip(tr(tip));
            button->setAccessibleName(tr(name));
        });
        button->setChecked(group->buttons().isEmpty());
        group->addButton(button, pictures->addWidget(page));
        choices->addWidget(button);
    };
    auto* tooth = new QWidget(side);
    auto* stack = new QVBoxLayout(tooth);
    stack->setContentsMargins(0, 0, 0, 0);
    stack->setSpacing(kSpace1);
    m_view = new ToleranceView(tooth);
    m_meaning = kit::formWords({}, kSmall, QFont::Normal, QPalette::PlaceholderText, tooth);
    stack->addWidget(m_view, 1);
    stack->addWidget(m_meaning);
    add(QT_TR_NOOP("On the tooth"), QT_TR_NOOP("What the tolerances mean on the tooth"), tooth);
    m_sweep = new SweepPage(side);
    add(QT_TR_NOOP("Past attempts"), QT_TR_NOOP("How attempts would score under other tolerances"), m_sweep);
    m_json = new QPlainTextEdit(side);
    m_json->setReadOnly(true);
    m_json->setFrameShape(QFrame::NoFrame);
    m_json->setTabChangesFocus(true);
    text::bindTranslation(m_json, [this] { m_json->setAccessibleName(tr("The lesson's file")); });
    QFont fixed(QStringLiteral("monospace"));
    fixed.setStyleHint(QFont::Monospace);
    fixed.setPixelSize(kSmall);
    m_json->setFont(fixed);
    add(QT_TR_NOOP("File"), QT_TR_NOOP("The lesson as its file says it"), m_json);
    choices->addStretch(1);
    connect(group, &QButtonGroup::idClicked, pictures, &QStackedWidget::setCurrentIndex);
    column->addLayout(choices);
    column->addWidget(pictures, 1);
    return side;
}

QWidget* LessonEditor::makeFoot(const Actions& actions)
{
    auto* foot = new QWidget(this);
    auto* row = new QHBoxLayout(foot);
    row->setContentsMargins(kSpace4, 0, 0, 0);
    row->setSpacing(kSpace2);
    m_save = new QPushButton(foot);
    m_save->setAutoDefault(true);
    text::bindTranslation(m_save, [this] { m_save->setText(tr("Save")); });
    m_save->setProperty("kind", "filled");
    text::bindTranslation(m_save, [this] {
        m_save->setAccessibleName(tr("Save the lesson"));
        m_save->setToolTip(tr("Write the lesson into your folder (Ctrl+S)"));
    });
    m_save->setObjectName(QStringLiteral("saveLesson"));
    connect(m_save, &QPushButton::clicked, this, &LessonEditor::save);
    row->addWidget(m_save);
    row->addWidget(pageButton(actions.undo, "quiet", foot));
    row->addWidget(pageButton(actions.redo, "quiet", foot));
    auto* said = new QVBoxLayout;
    said->setSpacing(0);
    m_check = kit::formWords({}, kBody, QFont::Medium, QPalette::WindowText, foot);
    m_check->setObjectName(QStringLiteral("selfCheck"));
    m_said = kit::formWords({}, kSmall, QFont::Normal, QPalette::PlaceholderText, foot);
    m_said->setObjectName(QStringLiteral("editorSaid"));
    said->addWidget(m_check);
    said->addWidget(m_said);
    row->addLayout(said, 1);
    m_fit = new QPushButton(foot);
    m_fit->setAutoDefault(true);
    text::bindTranslation(m_fit, [this] {
        m_fit->setText(tr("Fit"));
        m_fit->setToolTip(tr("Widen the tolerances until the ideal itself loses nothing"));
        m_fit->setAccessibleName(tr("Fit the tolerances to the ideal"));
    });
    connect(m_fit, &QPushButton::clicked, this, &LessonEditor::fitTolerances);
    m_fit->hide();
    row->addWidget(m_fit);
    m_anew = new QPushButton(foot);
    m_anew->setObjectName(QStringLiteral("openAnew"));
    m_anew->setAutoDefault(true);
    text::bindTranslation(m_anew, [this] {
        m_anew->setText(tr("Open anew"));
        m_anew->setToolTip(tr("Show what stands in the file now; a step back brings your own changes back"));
        m_anew->setAccessibleName(m_anew->text());
    });
    connect(m_anew, &QPushButton::clicked, this, &LessonEditor::openAnew);
    m_anew->hide();
    row->addWidget(m_anew);
    return foot;
}

void LessonEditor::edit(const ::lessons::ReadLesson& lesson, const QString& folder)
{
    // A teacher's version of a shipped lesson has a file once it is saved. If it has unsaved changes since, the same
    // draft is shown.
    QString present = lesson.file;
    for (const auto& [from, opened] : m_opened)
        if (opened.draft.file() == lesson.file && opened.draft.isChanged())
            present = from;
    if (Opened& opened = m_opened[present]; !opened.draft.isChanged()) {
        opened.draft.begin(lesson, folder);
        opened.lesson = *lesson.lesson;
    }
    turnTo(present);
}

/// Shows another draft. If it is invalid, shows its errors and nothing of the previous lesson.
void LessonEditor::turnTo(const QString& present)
{
    m_present = present;
    const ::lessons::Lesson& lesson = m_opened.at(present).lesson;
    m_isSaveWanted = false;
    m_weigher->forget();
    m_now.reset();
    m_good.reset();
    m_view->show(nullptr);
    m_meaning->clear();
    m_check->clear();
    m_fit->hide();
    m_ideal->begin(lesson.task);
    m_rubric->offerCriteria(lesson.rubric.criteria);
    m_rubric->showValues(draft().rubric());
    m_sweep->begin(lesson);
    offerReferences();
    showTitle();
    say(
        [isOwn = draft().isSavedOnce()] {
            return isOwn ? tr("This lesson of yours is changed where it stands.")
                         : tr("A shipped lesson: saved, it becomes one of your own, based on it.");
        },
        false);
    changed();
}

void LessonEditor::showTitle()
{
    const QString title = draft().title();
    setTitle(tr("Lesson editor: %1").arg(title));
    if (m_title->text() != title)
        m_title->setText(title);
}

bool LessonEditor::canUndo() const
{
    return m_opened.contains(m_present) && draft().canUndo();
}

bool LessonEditor::canRedo() const
{
    return m_opened.contains(m_present) && draft().canRedo();
}

void LessonEditor::undo()
{
    draft().undo();
    showTitle();
    changed();
}

void LessonEditor::redo()
{
    draft().redo();
    showTitle();
    changed();
}

void LessonEditor::changed()
{
    m_json->setPlainText(QString::fromUtf8(QJsonDocument(draft().object()).toJson()));
    if (draft().isChanged())
        say([] { return tr("Not saved yet."); }, false);
    emit stepsChanged();
    m_weigher->weigh(draft().object(), draft().file());
}

void LessonEditor::take(const std::shared_ptr<const EvaluatedDraft>& weighed, bool isNewest)
{
    m_now = weighed;
    if (weighed->assignment) {
        m_good = weighed;
        m_view->show(weighed);
    } else if (!m_good) {
        m_view->show(weighed);  // shows that the lesson is invalid
    }
    if (!isNewest)
        return;  // the inputs contain newer values
    if (weighed->assignment || !weighed->fields.empty())
        m_ideal->offerFields(weighed->fields);
    if (weighed->assignment) {
        m_rubric->offerCriteria(weighed->assignment->rubric.criteria);
        offerReferences();
        m_sweep->setDraft(weighed);
        showMeaning();
    }
    m_ideal->showValues(weighed->fields);
    m_rubric->showValues(draft().rubric());
    showFaults();
    showCheck();
    if (m_isSaveWanted)
        save();
}

/// Offers the ideals: the one computed by rule, and the captured ones in the lesson's folder.
void LessonEditor::offerReferences()
{
    const QString folder = QFileInfo(draft().file()).absolutePath();
    m_ideal->offerReferences(
        QDir(folder).entryList({QLatin1String(kIdeals)}, QDir::Files, QDir::Name),
        draft().object().value(QStringLiteral("ideal")).toObject().value(QStringLiteral("captured")).toString());
}

void LessonEditor::showMeaning()
{
    const QString meaning = text::freeWords(m_good->assignment->rubric);
    m_meaning->setText(meaning.isEmpty() ? tr("This rubric has no criterion that can be drawn on the tooth.")
                                         : tr("Costs nothing: %1.").arg(meaning));
}

/// Shows each error beside its field, and all others at the top.
void LessonEditor::showFaults()
{
    QStringList general;
    for (const ::lessons::ValidationIssue& fault : m_rubric->takeFaults(m_ideal->takeFaults(m_now->read.faults)))
        general << wordsOf(fault, draft());
    kit::showFault(m_generalFault, general.join(u' '));
}

/// Shows whether the ideal loses points. Graded like a student's attempt, it must lose none.
void LessonEditor::showCheck()
{
    const auto& itself = m_now->itself;
    QStringList losing;
    if (itself)
        for (const ::lessons::Criterion& line : itself->criteria)
            if (line.share > 0.0)
                losing << text::criterionName(line);
    const bool isFull = m_now->isFullMarks();
    QPalette colours = palette();
    const auto wrong = std::find_if(m_now->read.faults.begin(), m_now->read.faults.end(),
                                    [](const ::lessons::ValidationIssue& fault) { return fault.grave; });
    if (wrong != m_now->read.faults.end())
        colours.setColor(QPalette::WindowText, tones(palette()).harmText);
    else if (itself && !isFull)
        colours.setColor(QPalette::WindowText, tones(palette()).attentionText);
    m_check->setPalette(colours);
    m_check->setText(
        //: %1: where in the lesson, and what is wrong there
        wrong != m_now->read.faults.end() ? QStringLiteral("⚠ ") + tr("Wrong: %1").arg(wordsOf(*wrong, draft()))
        : !m_now->assignment              ? tr("The ideal is checked as soon as nothing is wrong.")
        : !itself                         ? tr("An exercise has no ideal that could be checked.")
        : isFull
            ? QStringLiteral("✓ ") + tr("The ideal scores %1 on itself").arg(text::points(itself->totalTenths))
            //: %1: points; %2: names of criteria
            : QStringLiteral("⚠ ") + tr("The ideal scores only %1 on itself; it loses at: %2")
                                         .arg(text::points(itself->totalTenths), losing.join(QStringLiteral(", "))));
    m_fit->setVisible(itself && !isFull);
}

/// Sets each tolerance to what the ideal itself needs, rounded up to the step of the input. A criterion that could not
/// be measured is left unchanged.
void LessonEditor::fitTolerances()
{
    if (!m_now || !m_now->itself)
        return;
    const auto& lines = m_now->itself->criteria;
    const auto& rules = m_now->read.lesson->rubric.criteria;
    QStringList left;
    for (std::size_t k = 0; k < lines.size() && k < rules.size(); ++k) {
        if (lines[k].share <= 0.0)
            continue;
        if (!lines[k].measured || lines[k].isTooEarly) {
            left << text::criterionName(lines[k]);
            continue;
        }
        const double scale = std::pow(10.0, RubricForm::decimalsOf(rules[k].unit));
        draft().setCriterion(static_cast<int>(k), "tolerance",
                             std::ceil((rules[k].tolerance + lines[k].error) * scale) / scale);
    }
    changed();
    if (!left.isEmpty())
        say(
            [names = left.join(QStringLiteral(", "))] {
                return tr("Not measured or not earned on this ideal, so no tolerance helps: %1. Mark by another "
                          "rubric.")
                    .arg(names);
            },
            true);
}

void LessonEditor::chooseReference(const QString& name)
{
    std::optional<core::preparation::Tolerances> tolerances;
    if (!name.isEmpty())
        if (const auto ideal = core::preparation::readCaptured(toPath(QFileInfo(draft().file()).dir().filePath(name))))
            tolerances = ideal->tolerances;
    draft().setCaptured(name, tolerances);
    changed();
}

void LessonEditor::askForRecordings()
{
    auto* dialog = new kit::FileDialog(this, tr("Take recordings as the reference …"), kit::documentsFolder());
    dialog->setFileMode(QFileDialog::ExistingFiles);
    dialog->setNameFilters({tr("Recordings (%1)").arg(QLatin1String(kRecordings))});
    connect(dialog, &QFileDialog::filesSelected, this, &LessonEditor::captureFrom);
    dialog->open();
}

void LessonEditor::captureFrom(const QStringList& recordings)
{
    std::vector<std::filesystem::path> paths;
    for (const QString& file : recordings)
        paths.push_back(toPath(file));
    const auto tolerances =
        m_good ? ::lessons::tolerancesOf(m_good->assignment->rubric) : core::preparation::Tolerances{};
    const QFileInfo lesson(draft().file());
    QDir().mkpath(lesson.absolutePath());
    QString name;
    for (int k = 1; name.isEmpty() || QFileInfo::exists(lesson.dir().filePath(name)); ++k)
        name = lesson.fileName().section(u'.', 0, 0) + (k > 1 ? u'-' + QString::number(k) : QString()) +
               QStringLiteral(".cuspideal");
    say([count = static_cast<int>(recordings.size())] { return tr("Replaying %n recording(s) …", nullptr, count); },
        false);
    m_ideal->setCapturing(true);
    // The destructor waits for the pool, so `this` is valid. It also removes queued calls.
    m_capturing.start([this, paths, tolerances, name, of = m_present, file = lesson.dir().filePath(name)] {
        const auto ideal = ::lessons::captureFrom(paths, tolerances);
        const core::Status written = ideal ? core::preparation::writeCaptured(toPath(file), *ideal)
                                           : core::Status(tl::unexpected(ideal.error()));
        QMetaObject::invokeMethod(
            this,
            [this, written, name, of] {
                m_ideal->setCapturing(false);
                if (!written) {
                    say([why = core::wordsOf(
                             written.error())] { return tr("No reference was made: %1").arg(text::faultWords(why)); },
                        true);
                    return;
                }
                m_opened.at(of).draft.setCaptured(name, {});
                if (of == m_present)
                    changed();
                say([name] { return tr("The reference is %1 beside your lessons.").arg(name); }, false);
            },
            Qt::QueuedConnection);
    });
}

void LessonEditor::setKnown(std::vector<MeasuredAttempt> attempts)
{
    m_sweep->setKnown(std::move(attempts));
}

void LessonEditor::readFolder(const QString& folder)
{
    m_sweep->readFolder(folder);
}

void LessonEditor::save()
{
    m_isSaveWanted = !m_now || m_weigher->isBusy();
    if (m_isSaveWanted)
        return;  // saves when the draft has been evaluated
    if (const QString whyNot = write(draft(), *m_now); !whyNot.isEmpty()) {
        refuseToSave(whyNot);
        return;
    }
    changed();
    say([file = QDir::toNativeSeparators(draft().file())] { return tr("Saved as %1.").arg(file); }, false);
    keepDrafts();
    emit lessonSaved(draft().file());
}

void LessonEditor::refuseToSave(const QString& whyNot)
{
    say([whyNot] { return whyNot; }, true);
    m_anew->setVisible(draft().isOvertaken());
}

/// Opens the lesson's file again. Undo restores the changes made here.
void LessonEditor::openAnew()
{
    const ::lessons::ReadLesson read = ::lessons::readLesson(draft().file());
    if (!read.lesson) {
        say(
            [file = QFileInfo(draft().file()).fileName()] {
                return tr("%1 is no lesson as it stands now, and was not opened. Look at it with whoever has changed "
                          "it.")
                    .arg(file);
            },
            true);
        m_anew->show();
        return;
    }
    m_opened.at(m_present).lesson = *read.lesson;
    draft().openAnew(read);
    turnTo(m_present);
    say([] { return tr("This is what stands in the file now. A step back brings your own changes back."); }, false);
    m_title->setFocus();
}

QString LessonEditor::unsavedChanges() const
{
    const auto count = static_cast<int>(
        std::count_if(m_opened.begin(), m_opened.end(), [](const auto& one) { return one.second.draft.isChanged(); }));
    return count == 0 ? QString() : tr("What you have changed in %n lesson(s) would be lost.", nullptr, count);
}

void LessonEditor::closeDrafts()
{
    keepDrafts();
    m_recoveryLock.reset();
    discardChanges();
}

void LessonEditor::discardChanges()
{
    for (auto& [from, opened] : m_opened) {
        if (!opened.draft.isChanged())
            continue;
        opened.draft.revert();
        if (from == m_present)
            turnTo(from);
    }
    keepDrafts();
}

QSet<QString> LessonEditor::unsavedFiles() const
{
    QSet<QString> files;
    for (const auto& [from, opened] : m_opened)
        if (opened.draft.isChanged())
            files << (opened.draft.isSavedOnce() ? opened.draft.file() : from);
    return files;
}

void LessonEditor::recover(const QString& folder, const QString& file)
{
    if (m_recoveryLock && file == m_recoveryFile)
        return;
    m_recoveryLock.reset();
    m_recoveryFile = file;
    m_kept = {};
    QDir().mkpath(QFileInfo(m_recoveryFile).absolutePath());
    core::FileLock lock((m_recoveryFile + QStringLiteral(".lock")).toStdU16String());
    if (!lock.isHeld())
        return;
    m_recoveryLock = std::move(lock);
    QFile in(m_recoveryFile);
    if (in.open(QIODevice::ReadOnly))
        m_kept = QJsonDocument::fromJson(in.read(kLargestRecovery)).array();
    for (const QJsonValue one : std::as_const(m_kept)) {
        const QString from = one["from"].toString();
        const ::lessons::ReadLesson read = ::lessons::readLesson(from);
        const QJsonObject object = one["lesson"].toObject();
        if (!read.lesson || object.isEmpty() || (m_opened.contains(from) && m_opened.at(from).draft.isChanged()))
            continue;
        Opened& opened = m_opened[from];
        opened.lesson = *read.lesson;
        opened.draft.begin(read, folder);
        opened.draft.goOnWith(object, one["saved"].toObject());
    }
    m_keeping.start(kKeepMs);
}

/// Updates the recovery file. Removes it if there are no unsaved drafts.
void LessonEditor::keepDrafts()
{
    QJsonArray all;
    for (const auto& [from, opened] : m_opened)
        if (opened.draft.isChanged())
            all.append(QJsonObject{{"from", opened.draft.isSavedOnce() ? opened.draft.file() : from},
                                   {"lesson", opened.draft.object()},
                                   {"saved", opened.draft.saved()}});
    if (!m_recoveryLock || all == m_kept)
        return;
    if (all.isEmpty()) {
        QFile::remove(m_recoveryFile);
        m_kept = all;
        return;
    }
    QSaveFile out(m_recoveryFile);
    const QByteArray bytes = QJsonDocument(all).toJson();
    if (kit::openForOwner(out) && out.write(bytes) == bytes.size() && out.flush() && out.commit())
        m_kept = all;
}

void LessonEditor::say(std::function<QString()> sentence, bool isWrong)
{
    m_saying = std::move(sentence);
    m_isSaidWrong = isWrong;
    m_anew->hide();
    QPalette colours = palette();
    colours.setColor(QPalette::PlaceholderText,
                     isWrong ? tones(palette()).harmText : palette().color(QPalette::PlaceholderText));
    m_said->setPalette(colours);
    m_said->setText((isWrong ? QStringLiteral("⚠ ") : QString()) + m_saying());
}

}  // namespace ui::lessoneditor
