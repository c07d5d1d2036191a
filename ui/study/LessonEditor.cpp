// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/LessonEditor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QAbstractItemView>
#include <QButtonGroup>
#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QJsonDocument>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "core/base/WholeFile.h"
#include "lessons/Capture.h"
#include "ui/shell/Actions.h"
#include "ui/shell/ScrollPane.h"
#include "ui/shell/Theme.h"
#include "ui/study/LessonWords.h"
#include "ui/study/SweepChart.h"
#include "ui/study/ToleranceView.h"
#include "ui/text/Texts.h"

namespace ui::study {
namespace {

using namespace ui::shell;

constexpr int kFormWidthPx = 430;
constexpr int kNarrowFormPx = 360;
constexpr int kSpinPx = 112;
constexpr const char* kRecordings = "*.cusprec";
constexpr const char* kIdeals = "*.cuspideal";

QLabel* words(const QString& text, int size, QFont::Weight weight, QPalette::ColorRole role, QWidget* parent)
{
    auto* made = new QLabel(text, parent);
    made->setFont(typeface(size, weight));
    made->setForegroundRole(role);
    made->setWordWrap(true);
    return made;
}

QLabel* faultLabel(QWidget* parent)
{
    auto* made = words({}, kSmall, QFont::Medium, QPalette::WindowText, parent);
    QPalette colours = made->palette();
    colours.setColor(QPalette::WindowText, tones(colours).harmText);
    made->setPalette(colours);
    made->setForegroundRole(QPalette::WindowText);
    made->hide();
    return made;
}

/// A sign before the words: a fault is not told by colour alone.
void showFault(QLabel* label, const QString& what)
{
    label->setText(what.isEmpty() ? QString() : QStringLiteral("⚠ ") + what);
    label->setVisible(!what.isEmpty());
}

std::filesystem::path toPath(const QString& file)
{
    return {file.toStdU16String()};
}

int decimalsOf(const std::string& unit)
{
    return unit == "mm" || unit == "mm2" || unit == "mm3" ? 2 : 1;
}

double stepOf(const std::string& unit)
{
    return unit == "mm" ? 0.05 : unit == "mm2" || unit == "mm3" ? 0.1 : 1.0;
}

std::string criteriaIds(const ::lessons::Rubric& rubric)
{
    std::string ids;
    for (const ::lessons::CriterionRule& rule : rubric.criteria)
        ids += rule.id + (rule.critical ? "! " : " ");
    return ids;
}

}  // namespace

LessonEditor::LessonEditor(const Actions& actions, QWidget* parent) : Page(actions, tr("Lesson editor"), parent)
{
    m_weighing.setMaxThreadCount(1);
    m_replaying.setMaxThreadCount(1);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace4);
    auto* form = new ScrollPane(makeForm(), QPalette::Window, this);
    form->setMinimumWidth(kNarrowFormPx);
    form->setMaximumWidth(kFormWidthPx);
    row->addWidget(form, 2);
    row->addWidget(makePictures(), 3);
    body()->addLayout(row, 1);
    body()->addWidget(makeFoot(actions));
}

LessonEditor::~LessonEditor()
{
    if (m_cancel)
        m_cancel->store(true);
    m_weighing.waitForDone();
    m_replaying.waitForDone();
}

LessonDraft& LessonEditor::draft()
{
    return m_drafts[m_present];
}

const LessonDraft& LessonEditor::draft() const
{
    return m_drafts.at(m_present);
}

QDoubleSpinBox* LessonEditor::spin(double low, double high, int decimals, const QString& unit, const QString& name)
{
    auto* made = new QDoubleSpinBox(this);
    made->setRange(low, high);
    made->setDecimals(decimals);
    made->setSuffix(unit.isEmpty() ? QString() : unit == u"°" ? unit : QStringLiteral(" ") + unit);
    made->setAccessibleName(name);
    made->setFixedWidth(kSpinPx);
    made->setFocusPolicy(Qt::StrongFocus);
    made->installEventFilter(this);
    for (auto* line : made->findChildren<QLineEdit*>())
        line->installEventFilter(this);
    return made;
}

QWidget* LessonEditor::makeForm()
{
    auto* form = new QWidget(this);
    auto* column = new QVBoxLayout(form);
    column->setContentsMargins(kSpace4, 0, kSpace4, kSpace2);
    column->setSpacing(kSpace2);
    const auto head = [&](const QString& text) {
        auto* made = words(text, kBody, QFont::DemiBold, QPalette::WindowText, form);
        column->addSpacing(kSpace2);
        column->addWidget(made);
        return made;
    };
    m_title = new QLineEdit(form);
    m_title->setAccessibleName(tr("Title of the lesson"));
    m_title->setObjectName(QStringLiteral("draftTitle"));
    m_title->installEventFilter(this);
    connect(m_title, &QLineEdit::textEdited, this, [this](const QString& title) {
        draft().setTitle(title, QLocale().name().section(u'_', 0, 0));
        changed();
    });
    column->addWidget(m_title);
    m_generalFault = faultLabel(form);
    column->addWidget(m_generalFault);

    m_idealHead = head(tr("Ideal preparation"));
    m_reference = new QComboBox(form);
    m_reference->setAccessibleName(tr("What the ideal is"));
    m_reference->view()->setAccessibleName(m_reference->accessibleName());
    m_reference->setObjectName(QStringLiteral("reference"));
    m_reference->setFocusPolicy(Qt::StrongFocus);
    m_reference->installEventFilter(this);
    connect(m_reference, &QComboBox::activated, this, &LessonEditor::chooseReference);
    column->addWidget(m_reference);
    m_fromRecordings = new QPushButton(tr("Take recordings as the reference …"), form);
    m_fromRecordings->setToolTip(tr("Choose one attempt, or several whose mean is to be cut"));
    m_fromRecordings->setAccessibleName(m_fromRecordings->text());
    connect(m_fromRecordings, &QPushButton::clicked, this, &LessonEditor::askForRecordings);
    column->addWidget(m_fromRecordings, 0, Qt::AlignLeft);
    m_idealFault = faultLabel(form);
    column->addWidget(m_idealFault);
    m_fieldsSlot = new QVBoxLayout;
    column->addLayout(m_fieldsSlot);

    head(tr("Marking"));
    m_rubricSlot = new QVBoxLayout;
    column->addLayout(m_rubricSlot);
    m_sum = words({}, kBody, QFont::Medium, QPalette::WindowText, form);
    column->addWidget(m_sum);
    auto* pass = new QHBoxLayout;
    pass->addWidget(words(tr("Passed from"), kBody, QFont::Normal, QPalette::WindowText, form), 1);
    m_passMark = spin(0.0, 100.0, 1, tr("points"), tr("Pass mark"));
    m_passMark->setFixedWidth(kSpinPx + kSpace4);
    connect(m_passMark, &QDoubleSpinBox::valueChanged, this, [this](double points) {
        if (m_isFilling)
            return;
        draft().setPassMark(points);
        changed();
    });
    pass->addWidget(m_passMark);
    column->addLayout(pass);
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
    m_pictures = new QStackedWidget(side);
    const auto add = [&](const QString& name, const QString& tip, QWidget* page) {
        auto* button = new QPushButton(name, side);
        button->setProperty("kind", "segment");
        button->setCheckable(true);
        button->setToolTip(tip);
        button->setAccessibleName(name);
        button->setChecked(group->buttons().isEmpty());
        group->addButton(button, m_pictures->addWidget(page));
        choices->addWidget(button);
    };
    auto* tooth = new QWidget(side);
    auto* stack = new QVBoxLayout(tooth);
    stack->setContentsMargins(0, 0, 0, 0);
    stack->setSpacing(kSpace1);
    m_view = new ToleranceView(tooth);
    m_meaning = words({}, kSmall, QFont::Normal, QPalette::PlaceholderText, tooth);
    stack->addWidget(m_view, 1);
    stack->addWidget(m_meaning);
    add(tr("On the tooth"), tr("What the tolerances mean on the tooth"), tooth);
    add(tr("Past attempts"), tr("How attempts would score under other tolerances"), makeSweep());
    m_json = new QPlainTextEdit(side);
    m_json->setReadOnly(true);
    m_json->setFrameShape(QFrame::NoFrame);
    m_json->setTabChangesFocus(true);
    m_json->setAccessibleName(tr("The lesson's file"));
    QFont fixed(QStringLiteral("monospace"));
    fixed.setStyleHint(QFont::Monospace);
    fixed.setPixelSize(kSmall);
    m_json->setFont(fixed);
    add(tr("File"), tr("The lesson as its file says it"), m_json);
    choices->addStretch(1);
    connect(group, &QButtonGroup::idClicked, m_pictures, &QStackedWidget::setCurrentIndex);
    column->addLayout(choices);
    column->addWidget(m_pictures, 1);
    return side;
}

QWidget* LessonEditor::makeSweep()
{
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace2);
    auto* row = new QHBoxLayout;
    auto* folder = new QPushButton(tr("Recordings …"), page);
    folder->setToolTip(tr("Choose the folder with recordings of attempts"));
    folder->setAccessibleName(tr("Choose the folder with recordings"));
    folder->setObjectName(QStringLiteral("sweepFolder"));
    connect(folder, &QPushButton::clicked, this, &LessonEditor::askForFolder);
    row->addWidget(folder);
    m_swept = new QComboBox(page);
    m_swept->setAccessibleName(tr("Whose tolerance is changed"));
    m_swept->view()->setAccessibleName(m_swept->accessibleName());
    m_swept->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_swept->setMinimumContentsLength(12);
    m_swept->setFocusPolicy(Qt::StrongFocus);
    m_swept->installEventFilter(this);
    connect(m_swept, &QComboBox::activated, this, &LessonEditor::sweepAgain);
    row->addWidget(m_swept, 1);
    column->addLayout(row);
    auto* work = new QHBoxLayout;
    m_progress = new QProgressBar(page);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Recordings that are replayed"));
    m_stop = new QPushButton(tr("Stop"), page);
    m_stop->setProperty("kind", "quiet");
    m_stop->setAccessibleName(tr("Stop replaying"));
    m_stop->setToolTip(tr("Go on with those that are done"));
    connect(m_stop, &QPushButton::clicked, this, [this] {
        if (m_cancel)
            m_cancel->store(true);
        m_stop->setEnabled(false);
    });
    work->addWidget(m_progress, 1);
    work->addWidget(m_stop);
    column->addLayout(work);
    m_progress->hide();
    m_stop->hide();
    m_chart = new SweepChart(page);
    column->addWidget(m_chart, 1);
    m_sweepWords = words(tr("Choose a folder with recordings of this tooth: each is replayed once, and its score is "
                            "drawn for tolerances from 0 to 3 times those at the left."),
                         kSmall, QFont::Normal, QPalette::PlaceholderText, page);
    m_sweepWords->setObjectName(QStringLiteral("sweepWords"));
    column->addWidget(m_sweepWords);
    connect(m_chart, &SweepChart::pointedAt, m_sweepWords, &QLabel::setText);
    return page;
}

QWidget* LessonEditor::makeFoot(const Actions& actions)
{
    auto* foot = new QWidget(this);
    auto* row = new QHBoxLayout(foot);
    row->setContentsMargins(kSpace4, 0, 0, 0);
    row->setSpacing(kSpace2);
    m_save = new QPushButton(tr("Save"), foot);
    m_save->setProperty("kind", "filled");
    m_save->setAccessibleName(tr("Save the lesson"));
    m_save->setToolTip(tr("Write the lesson into your folder (Ctrl+S)"));
    m_save->setObjectName(QStringLiteral("saveLesson"));
    connect(m_save, &QPushButton::clicked, this, &LessonEditor::save);
    row->addWidget(m_save);
    row->addWidget(pageButton(actions.undo, "quiet", foot));
    row->addWidget(pageButton(actions.redo, "quiet", foot));
    auto* said = new QVBoxLayout;
    said->setSpacing(0);
    m_check = words({}, kBody, QFont::Medium, QPalette::WindowText, foot);
    m_check->setObjectName(QStringLiteral("selfCheck"));
    m_said = words({}, kSmall, QFont::Normal, QPalette::PlaceholderText, foot);
    m_said->setObjectName(QStringLiteral("editorSaid"));
    said->addWidget(m_check);
    said->addWidget(m_said);
    row->addLayout(said, 1);
    m_fit = new QPushButton(tr("Fit"), foot);
    m_fit->setToolTip(tr("Widen the tolerances until the ideal itself loses nothing"));
    m_fit->setAccessibleName(tr("Fit the tolerances to the ideal"));
    connect(m_fit, &QPushButton::clicked, this, &LessonEditor::fitTolerances);
    m_fit->hide();
    row->addWidget(m_fit);
    return foot;
}

void LessonEditor::edit(const ::lessons::ReadLesson& lesson, const QString& folder)
{
    m_present = lesson.file;
    if (!m_drafts.contains(m_present) || !draft().isChanged())
        draft().begin(lesson, folder);
    m_opened = lesson.lesson;
    m_known.clear();
    m_measured.clear();
    m_now.reset();
    m_measuredFor.reset();
    m_rubricShown.clear();
    setTitle(tr("Lesson editor: %1").arg(said(lesson.lesson->title)));
    m_title->setText(said(lesson.lesson->title));
    say(lesson.file.startsWith(u':') ? tr("A shipped lesson: saved, it becomes one of your own, based on it.")
                                     : tr("This lesson of yours is changed where it stands."),
        false);
    // At once what can be seen at once; the rest comes from the pool.
    fillReferences();
    changed();
}

bool LessonEditor::canUndo() const
{
    return m_drafts.contains(m_present) && draft().canUndo();
}

bool LessonEditor::canRedo() const
{
    return m_drafts.contains(m_present) && draft().canRedo();
}

void LessonEditor::undo()
{
    draft().undo();
    changed();
}

void LessonEditor::redo()
{
    draft().redo();
    changed();
}

void LessonEditor::changed()
{
    m_json->setPlainText(QString::fromUtf8(QJsonDocument(draft().object()).toJson()));
    if (draft().isChanged())
        say(tr("Not saved yet."), false);
    emit stepsChanged();
    weighLater();
}

/// One at a time, and only the newest.
void LessonEditor::weighLater()
{
    m_isWanted = m_isWeighing;
    if (m_isWeighing)
        return;
    m_isWeighing = true;
    const QPointer<LessonEditor> self(this);
    m_weighing.start([self, object = draft().object(), file = draft().file(), of = m_present, before = m_good] {
        const auto weighed = weigh(object, file, before);
        QMetaObject::invokeMethod(
            qApp,
            [self, weighed, of] {
                if (!self)
                    return;
                self->m_isWeighing = false;
                if (of == self->m_present)
                    self->take(weighed);
                if (std::exchange(self->m_isWanted, false) || of != self->m_present)
                    self->weighLater();
                else if (self->m_isSaveWanted)
                    self->save();
            },
            Qt::QueuedConnection);
    });
}

void LessonEditor::take(const std::shared_ptr<const Weighed>& weighed)
{
    m_now = weighed;
    if (weighed->assignment) {
        m_good = weighed;
        m_view->show(weighed);
    }
    if (m_isWanted)
        return;  // what is in the inputs is newer
    if (weighed->assignment) {
        fillFields();
        fillRubric();
        fillReferences();
        measureLater();
    }
    showValues();
    showFaults();
    showCheck();
}

/// Inputs for the numbers that this ideal has. They are made anew only where it has others.
void LessonEditor::fillFields()
{
    const bool isSame = m_fields != nullptr && m_fieldInputs.size() == m_good->fields.size() &&
                        std::all_of(m_good->fields.begin(), m_good->fields.end(),
                                    [&](const IdealField& field) { return m_fieldInputs.contains(field.id); });
    if (isSame)
        return;
    delete m_fields;
    m_fieldInputs.clear();
    m_fieldFaults.clear();
    m_fields = new QWidget(this);
    auto* grid = new QGridLayout(m_fields);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kSpace2);
    grid->setVerticalSpacing(kSpace1);
    grid->setColumnStretch(0, 1);
    int row = 0;
    for (const IdealField& field : m_good->fields) {
        const bool isChoice = field.whole && field.minimum == 0.0 && field.maximum == 1.0;
        const auto set = [this, id = field.id](double value) {
            if (m_isFilling)
                return;
            draft().setSize(id, value);
            changed();
        };
        QWidget* input = nullptr;
        if (isChoice) {
            auto* choice = new QComboBox(m_fields);
            choice->addItems({tr("no"), tr("yes")});
            choice->setAccessibleName(field.name);
            choice->view()->setAccessibleName(field.name);
            choice->setFixedWidth(kSpinPx);
            choice->setFocusPolicy(Qt::StrongFocus);
            choice->installEventFilter(this);
            connect(choice, &QComboBox::activated, this, [set](int index) { set(index); });
            input = choice;
        } else {
            auto* number = spin(field.minimum, field.maximum, field.whole ? 0 : 2, field.unit, field.name);
            number->setSingleStep(field.whole || field.unit == u"°" ? 1.0 : 0.05);
            //: %1 and %2: the least and the greatest number that can be set; %3: a unit
            number->setToolTip(
                tr("%1 to %2 %3")
                    .arg(QLocale().toString(field.minimum), QLocale().toString(field.maximum), field.unit)
                    .trimmed());
            connect(number, &QDoubleSpinBox::valueChanged, this, set);
            input = number;
        }
        input->setObjectName(field.id);
        grid->addWidget(words(field.name, kBody, QFont::Normal, QPalette::WindowText, m_fields), row, 0);
        grid->addWidget(input, row, 1);
        auto* fault = faultLabel(m_fields);
        grid->addWidget(fault, ++row, 0, 1, 2);
        m_fieldInputs[field.id] = input;
        m_fieldFaults[field.id] = fault;
        ++row;
    }
    m_fieldsSlot->addWidget(m_fields);
}

void LessonEditor::fillRubric()
{
    const ::lessons::Rubric& rubric = m_good->assignment->rubric;
    if (std::exchange(m_rubricShown, criteriaIds(rubric)) == criteriaIds(rubric))
        return;
    delete m_rubric;
    m_criteria.clear();
    m_rubric = new QWidget(this);
    auto* grid = new QGridLayout(m_rubric);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kSpace2);
    grid->setVerticalSpacing(kSpace1);
    grid->setColumnStretch(0, 1);
    grid->addWidget(words(tr("Tolerance"), kSmall, QFont::Normal, QPalette::PlaceholderText, m_rubric), 0, 1);
    grid->addWidget(words(tr("Weight"), kSmall, QFont::Normal, QPalette::PlaceholderText, m_rubric), 0, 2);
    m_swept->clear();
    m_swept->addItem(tr("All tolerances"));
    int row = 1;
    for (const ::lessons::CriterionRule& rule : rubric.criteria) {
        const int index = static_cast<int>(m_criteria.size());
        Criterion inputs;
        const QString name = titleOf(rule);
        m_swept->addItem(name);
        auto* label = words(name, kBody, QFont::Normal, QPalette::WindowText, m_rubric);
        grid->addWidget(label, row, 0);
        const auto add = [&](QDoubleSpinBox* input, const char* key, int column) {
            grid->addWidget(input, row, column);
            connect(input, &QDoubleSpinBox::valueChanged, this, [this, index, key](double value) {
                if (m_isFilling)
                    return;
                draft().setCriterion(index, key, value);
                changed();
            });
            return input;
        };
        inputs.tolerance = add(spin(0.0, 1000.0, decimalsOf(rule.unit), text::unitName(rule.unit),
                                    //: %1: a criterion
                                    tr("Tolerance of: %1").arg(name)),
                               "tolerance", 1);
        inputs.tolerance->setSingleStep(stepOf(rule.unit));
        inputs.tolerance->setObjectName(QStringLiteral("tolerance.") + QString::fromStdString(rule.id));
        inputs.tolerance->setFixedWidth(kSpinPx - kSpace2);
        if (rule.critical) {
            grid->addWidget(words(tr("fails"), kBody, QFont::Normal, QPalette::PlaceholderText, m_rubric), row, 2);
        } else {
            inputs.weight = add(spin(0.1, 100.0, 1, {}, tr("Weight of: %1").arg(name)), "weight", 2);
            inputs.weight->setFixedWidth(kSpinPx - kSpace6);
        }
        inputs.fault = faultLabel(m_rubric);
        grid->addWidget(inputs.fault, ++row, 0, 1, 3);
        m_criteria.push_back(inputs);
        ++row;
    }
    m_rubricSlot->addWidget(m_rubric);
}

/// What the ideal can be: by rule, or each captured one that lies beside the lesson.
void LessonEditor::fillReferences()
{
    const bool hasIdeal = m_good && m_good->assignment && m_good->assignment->lesson->task == ::lessons::Task::CutIdeal;
    m_idealHead->setText(hasIdeal || (m_good && !m_good->fields.empty())
                             ? tr("Ideal preparation")
                             : tr("The ideal is the decay itself: nothing is to be set"));
    m_reference->setVisible(hasIdeal);
    m_fromRecordings->setVisible(hasIdeal);
    const QString folder = QFileInfo(draft().file()).absolutePath();
    QStringList names = QDir(folder).entryList({QLatin1String(kIdeals)}, QDir::Files, QDir::Name);
    const QString present =
        draft().object().value(QStringLiteral("ideal")).toObject().value(QStringLiteral("captured")).toString();
    if (!present.isEmpty() && !names.contains(present))
        names.prepend(present);
    m_reference->clear();
    m_reference->addItem(tr("By rule"));
    for (const QString& name : names)
        //: %1: the name of a file
        m_reference->addItem(tr("Captured: %1").arg(name), name);
    m_reference->setCurrentIndex(present.isEmpty() ? 0 : static_cast<int>(names.indexOf(present)) + 1);
}

/// Into the inputs: what the draft says, be it from them or from a step back.
void LessonEditor::showValues()
{
    m_isFilling = true;
    if (m_good) {
        for (const IdealField& field : m_now->fields) {
            const auto found = m_fieldInputs.find(field.id);
            if (found == m_fieldInputs.end())
                continue;
            if (auto* choice = qobject_cast<QComboBox*>(found->second))
                choice->setCurrentIndex(field.value > 0.5 ? 1 : 0);
            else if (auto* number = qobject_cast<QDoubleSpinBox*>(found->second))
                number->setValue(field.value);
        }
        const ::lessons::Rubric& rubric =
            (m_now->read.lesson ? *m_now->read.lesson : *m_good->assignment->lesson).rubric;
        for (std::size_t k = 0; k < m_criteria.size() && k < rubric.criteria.size() && m_now->read.lesson; ++k) {
            m_criteria[k].tolerance->setValue(rubric.criteria[k].tolerance);
            if (m_criteria[k].weight != nullptr)
                m_criteria[k].weight->setValue(0.1 * rubric.criteria[k].weightTenths);
        }
        if (m_now->read.lesson) {
            m_passMark->setValue(0.1 * rubric.passMarkTenths);
            if (!m_title->hasFocus())
                m_title->setText(said(m_now->read.lesson->title));
        }
        const auto tolerances = ::lessons::tolerancesOf(rubric, {-1.0, -1.0, -1.0, -1.0});
        QStringList meaning;
        const auto figure = [](double value) { return QLocale().toString(value, 'g', 3); };
        if (tolerances.outlineMm >= 0.0)
            meaning << tr("outline %1 mm to either side").arg(figure(tolerances.outlineMm));
        if (tolerances.depthMm >= 0.0)
            meaning << tr("floor %1 mm up or down").arg(figure(tolerances.depthMm));
        constexpr double kRadPerDeg = 3.14159265358979 / 180.0;
        if (tolerances.wallDeg >= 0.0)
            meaning << tr("walls %1°, that is %2 mm over 1.5 mm of depth")
                           .arg(figure(tolerances.wallDeg), figure(1.5 * std::tan(tolerances.wallDeg * kRadPerDeg)));
        if (tolerances.floorMm >= 0.0)
            meaning << tr("floor even to %1 mm").arg(figure(tolerances.floorMm));
        m_meaning->setText(meaning.isEmpty() ? tr("This rubric has no criterion that can be drawn on the tooth.")
                                             : tr("Costs nothing: %1.").arg(meaning.join(QStringLiteral("; "))));
    }
    m_isFilling = false;
    double sum = 0.0;
    for (const Criterion& inputs : m_criteria)
        sum += inputs.weight != nullptr ? inputs.weight->value() : 0.0;
    const bool isWhole = std::abs(sum - 100.0) < 0.01;
    QPalette colours = palette();
    if (!isWhole)
        colours.setColor(QPalette::WindowText, tones(palette()).harmText);
    m_sum->setPalette(colours);
    m_sum->setText((isWhole ? QString() : QStringLiteral("⚠ ")) +
                   (isWhole ? tr("All weights: %1 points").arg(text::number(sum, 1))
                            : tr("All weights: %1 points; they must make 100").arg(text::number(sum, 1))));
}

/// Each beside what it is about; what has no place of its own at the top.
void LessonEditor::showFaults()
{
    std::map<QLabel*, QString> faults{{m_generalFault, {}}, {m_idealFault, {}}};
    for (const auto& [id, label] : m_fieldFaults)
        faults[label] = {};
    for (const Criterion& inputs : m_criteria)
        faults[inputs.fault] = {};
    for (const ::lessons::Fault& fault : m_now->read.faults) {
        QLabel* label = m_generalFault;
        for (std::size_t k = 0; k < m_criteria.size(); ++k)
            if (fault.key.startsWith(QStringLiteral("rubric.criteria[%1]").arg(k)))
                label = m_criteria[k].fault;
        if (fault.key.startsWith(u"ideal") || fault.key.startsWith(u"tooth"))
            label = m_idealFault;
        for (const auto& [id, beside] : m_fieldFaults)
            if (fault.key.endsWith(u'.' + id) || fault.what.contains(u'(' + id + u')'))
                label = beside;
        // The sum says it, beside the weights.
        if (fault.key == u"rubric" && fault.what.contains(u"weight"))
            continue;
        QString& said = faults[label];
        said += (said.isEmpty() ? QString() : QStringLiteral(" ")) +
                (label == m_generalFault ? fault.sentence() : text::capitalised(fault.what));
    }
    for (const auto& [label, what] : faults)
        showFault(label, what);
}

/// The ideal, marked as if a student had cut it, must lose nothing.
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
    if (itself && !isFull)
        colours.setColor(QPalette::WindowText, tones(palette()).attentionText);
    m_check->setPalette(colours);
    m_check->setText(
        !itself ? tr("The ideal is checked as soon as nothing is wrong.")
        : isFull
            ? QStringLiteral("✓ ") + tr("The ideal scores %1 on itself").arg(text::points(itself->totalTenths))
            //: %1: points; %2: names of criteria
            : QStringLiteral("⚠ ") + tr("The ideal scores only %1 on itself; it loses at: %2")
                                         .arg(text::points(itself->totalTenths), losing.join(QStringLiteral(", "))));
    m_fit->setVisible(itself && !isFull);
}

/// As wide as the ideal itself needs, to the next step of the input. What was not measured cannot be fitted.
void LessonEditor::fitTolerances()
{
    if (!m_now || !m_now->itself)
        return;
    const auto lines = m_now->itself->criteria;
    QStringList left;
    for (std::size_t k = 0; k < lines.size() && k < m_criteria.size(); ++k) {
        if (lines[k].share <= 0.0)
            continue;
        if (!lines[k].measured) {
            left << text::criterionName(lines[k]);
            continue;
        }
        const double scale = std::pow(10.0, m_criteria[k].tolerance->decimals());
        const double now = m_now->read.lesson->rubric.criteria[k].tolerance;
        draft().setCriterion(static_cast<int>(k), "tolerance", std::ceil((now + lines[k].error) * scale) / scale);
    }
    changed();
    if (!left.isEmpty())
        say(tr("Not measured on this ideal, so no tolerance helps: %1. Mark by another rubric.")
                .arg(left.join(QStringLiteral(", "))),
            true);
}

void LessonEditor::chooseReference(int index)
{
    const QString name = m_reference->itemData(index).toString();
    std::optional<core::preparation::Tolerances> tolerances;
    if (!name.isEmpty())
        if (const auto ideal = core::preparation::readCaptured(toPath(QFileInfo(draft().file()).dir().filePath(name))))
            tolerances = ideal->tolerances;
    draft().setCaptured(name, tolerances);
    changed();
}

void LessonEditor::askForRecordings()
{
    auto* dialog = new QFileDialog(this, m_fromRecordings->text());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFiles);
    dialog->setNameFilters({tr("Recordings (%1)").arg(QLatin1String(kRecordings))});
    connect(dialog, &QFileDialog::filesSelected, this, &LessonEditor::captureFrom);
    connect(dialog, &QDialog::finished, window(), [this] { window()->activateWindow(); });
    dialog->open();
}

void LessonEditor::captureFrom(const QStringList& recordings)
{
    std::vector<std::filesystem::path> paths;
    for (const QString& file : recordings)
        paths.push_back(toPath(file));
    const auto tolerances = m_good && m_good->assignment ? ::lessons::tolerancesOf(m_good->assignment->rubric)
                                                         : core::preparation::Tolerances{};
    const QFileInfo lesson(draft().file());
    QDir().mkpath(lesson.absolutePath());
    QString name;
    for (int k = 1; name.isEmpty() || QFileInfo::exists(lesson.dir().filePath(name)); ++k)
        name = lesson.fileName().section(u'.', 0, 0) + (k > 1 ? u'-' + QString::number(k) : QString()) +
               QStringLiteral(".cuspideal");
    say(tr("Replaying %n recording(s) …", nullptr, static_cast<int>(recordings.size())), false);
    m_fromRecordings->setEnabled(false);
    const QPointer<LessonEditor> self(this);
    m_replaying.start([self, paths, tolerances, name, of = m_present, file = lesson.dir().filePath(name)] {
        const auto ideal = ::lessons::captureFrom(paths, tolerances);
        const core::Status written = ideal ? core::preparation::writeCaptured(toPath(file), *ideal)
                                           : core::Status(tl::unexpected(ideal.error()));
        QMetaObject::invokeMethod(
            qApp,
            [self, written, name, of] {
                if (!self)
                    return;
                self->m_fromRecordings->setEnabled(true);
                if (!written) {
                    self->say(tr("No reference was made: %1").arg(QString::fromStdString(written.error().detail)),
                              true);
                    return;
                }
                self->m_drafts[of].setCaptured(name, {});
                if (of == self->m_present)
                    self->changed();
                self->say(tr("The reference is %1 beside your lessons.").arg(name), false);
            },
            Qt::QueuedConnection);
    });
}

void LessonEditor::askForFolder()
{
    auto* dialog = new QFileDialog(this, tr("Choose the folder with recordings"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, this, &LessonEditor::readFolder);
    connect(dialog, &QDialog::finished, window(), [this] { window()->activateWindow(); });
    dialog->open();
}

void LessonEditor::readFolder(const QString& folder)
{
    if (m_cancel)
        m_cancel->store(true);
    m_cancel = std::make_shared<std::atomic<bool>>(false);
    const int reading = ++m_reading;
    m_progress->setRange(0, 0);
    m_progress->show();
    m_stop->setEnabled(true);
    m_stop->show();
    const QPointer<LessonEditor> self(this);
    const auto later = [self, reading](auto what) {
        QMetaObject::invokeMethod(
            qApp,
            [self, reading, what] {
                if (self && reading == self->m_reading)
                    what(*self);
            },
            Qt::QueuedConnection);
    };
    m_replaying.start([later, folder, cancel = m_cancel] {
        const auto told = [&](int done, int of) {
            later([done, of](LessonEditor& editor) {
                editor.m_progress->setRange(0, std::max(1, of));
                editor.m_progress->setValue(done);
            });
        };
        const auto past = std::make_shared<const PastAttempts>(readAttempts(folder, told, *cancel));
        later([past](LessonEditor& editor) { editor.takeAttempts(past); });
    });
}

void LessonEditor::takeAttempts(const std::shared_ptr<const PastAttempts>& past)
{
    m_past = past;
    m_progress->hide();
    m_stop->hide();
    m_measuredFor.reset();
    m_sweepWords->setToolTip(brokenIntoLines(past->faults.join(u'\n')));
    measureLater();
}

/// Against this ideal, if they have not been; then only marked.
void LessonEditor::measureLater()
{
    if (!m_past) {
        sweepAgain();
        return;
    }
    if (!m_good || !m_good->assignment)
        return;
    const core::grading::IdealTop ideal = m_good->assignment->shownIdeal();
    if (m_measuredFor && m_measuredFor == ideal) {
        sweepAgain();
        return;
    }
    m_measuredFor = ideal;
    const QPointer<LessonEditor> self(this);
    m_replaying.start([self, ideal, good = m_good, past = m_past] {
        const auto measured =
            std::make_shared<std::vector<MeasuredAttempt>>(measureAttempts(*good->assignment, past->attempts));
        QMetaObject::invokeMethod(
            qApp,
            [self, ideal, measured] {
                if (!self || self->m_measuredFor != ideal)
                    return;
                self->m_measured = std::move(*measured);
                self->sweepAgain();
            },
            Qt::QueuedConnection);
    });
}

void LessonEditor::setKnown(std::vector<MeasuredAttempt> attempts)
{
    m_known = std::move(attempts);
    sweepAgain();
}

void LessonEditor::sweepAgain()
{
    if (!m_good || !m_good->assignment)
        return;
    // What the history knows was measured against the ideal as it was.
    const ::lessons::Lesson& lesson = *m_good->assignment->lesson;
    const bool isAsOpened = m_opened && m_opened->ideal == lesson.ideal && m_opened->tooth == lesson.tooth &&
                            m_opened->lesion == lesson.lesion && m_opened->leeway == lesson.leeway;
    std::vector<MeasuredAttempt> attempts = m_measured;
    if (isAsOpened)
        attempts.insert(attempts.end(), m_known.begin(), m_known.end());
    if (!m_past && attempts.empty())
        return;
    m_chart->setSweep(sweepOf(m_good->assignment->rubric, attempts, m_swept->currentIndex() - 1));
    QStringList said;
    if (!attempts.empty())
        said << m_chart->words(1.0) + u'.';
    else
        said << tr("No attempt in this folder was made at this tooth.");
    if (isAsOpened && !m_known.empty())
        said << tr("%n of them from the history.", nullptr, static_cast<int>(m_known.size()));
    const int others = m_past ? static_cast<int>(m_past->attempts.size() - m_measured.size()) : 0;
    if (!m_measured.empty() && others > 0)
        said << tr("%n attempt(s) at other teeth are left out.", nullptr, others);
    if (m_past && !m_past->faults.isEmpty())
        said << tr("%n recording(s) could not be read.", nullptr, static_cast<int>(m_past->faults.size()));
    m_sweepWords->setText(said.join(u' '));
}

void LessonEditor::save()
{
    m_isSaveWanted = !m_now || m_isWeighing;
    if (m_isSaveWanted)
        return;  // as soon as it is checked
    for (const ::lessons::Fault& fault : m_now->read.faults)
        if (fault.grave) {
            say(tr("Not saved: %1").arg(fault.sentence()), true);
            return;
        }
    if (m_now->itself && !m_now->isFullMarks()) {
        say(tr("Not saved: whoever cuts exactly this ideal would lose points. Widen the tolerances that are named, or "
               "press Fit."),
            true);
        return;
    }
    const QString file = draft().file();
    if (!draft().isSavedOnce() && QFileInfo::exists(file)) {
        say(tr("Not saved: there is a file %1 already. Open that lesson instead.").arg(QFileInfo(file).fileName()),
            true);
        return;
    }
    QDir().mkpath(QFileInfo(file).absolutePath());
    const QByteArray json = draft().stamped();
    const core::Status written =
        core::writeWhole(toPath(file), {json.constData(), static_cast<std::size_t>(json.size())}, "The lesson");
    if (!written) {
        say(tr("Not saved: %1").arg(QString::fromStdString(written.error().detail)), true);
        return;
    }
    changed();
    say(tr("Saved as %1.").arg(QDir::toNativeSeparators(file)), false);
    emit lessonSaved(file);
}

void LessonEditor::say(const QString& sentence, bool isWrong)
{
    QPalette colours = palette();
    colours.setColor(QPalette::PlaceholderText,
                     isWrong ? tones(palette()).harmText : palette().color(QPalette::PlaceholderText));
    m_said->setPalette(colours);
    m_said->setText((isWrong ? QStringLiteral("⚠ ") : QString()) + sentence);
}

/// Undo belongs to the page and not to one input; and a wheel over an input that nobody has chosen scrolls the form.
bool LessonEditor::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    if (event->type() == QEvent::Wheel && !qobject_cast<QWidget*>(watched)->hasFocus()) {
        event->ignore();
        return true;
    }
    return Page::eventFilter(watched, event);
}

}  // namespace ui::study
