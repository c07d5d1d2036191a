// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/ClassPage.h"

#include <algorithm>
#include <array>

#include <QButtonGroup>
#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QSaveFile>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/charts/ChartPanel.h"
#include "ui/kit/Accessibility.h"
#include "ui/kit/FileDialog.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/ListTable.h"
#include "ui/kit/PrivateFile.h"
#include "ui/kit/ScrollPane.h"
#include "ui/kit/StandardFolders.h"
#include "ui/kit/Theme.h"
#include "ui/people/ClassCharts.h"
#include "ui/text/EveryLanguage.h"

namespace ui::people {
namespace {

using database::MatrixStudent;
using namespace ui::kit;

constexpr int kLessonPx = 104;
constexpr int kHeadPx = 62;  ///< height of three lines of a lesson's title
constexpr int kDuePx = 18;   ///< height of one line with the due date
constexpr int kNamesPx = 250;
constexpr int kLeastChooserPx = 240;
constexpr int kSearchPx = 240;
constexpr int kLeastMatrixPx = 240;
constexpr int kLeastChartsPx = 280;
constexpr std::array kNeeds{Need::NoneLeft, Need::Stuck, Need::NeverLoggedIn, Need::Late, Need::NotBegun};

}  // namespace

ClassPage::ClassPage(const Actions& actions, QWidget* parent)
    : Page(actions, parent), m_model(new ClassModel(this)), m_filter(new ClassFilter(m_model))
{
    body()->setSpacing(kSpace2);
    body()->addWidget(makeHead());
    // If the window is low or the text large, both parts keep a readable height and the page scrolls.
    auto* both = new QWidget(this);
    auto* column = new QVBoxLayout(both);
    both->setMinimumWidth(1);  // follows the width of the page, so that nothing scrolls sideways
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace2);
    column->addWidget(makeMatrix(), 1);
    m_charts = makeCharts();
    column->addWidget(m_charts, 1);
    m_stack->setMinimumHeight(kLeastMatrixPx);
    m_charts->setMinimumHeight(kLeastChartsPx);
    body()->addWidget(new ScrollPane(both, QPalette::Window, this), 1);
    retell();
}

/// Makes the top of the page: the choice of class, the filters for students who need help, and the actions for the
/// whole class.
QWidget* ClassPage::makeHead()
{
    auto* part = new QWidget(this);
    auto* rows = new QVBoxLayout(part);
    rows->setContentsMargins(kSpace2, 0, kSpace2, 0);
    rows->setSpacing(kSpace2);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace2);
    rows->addLayout(row);
    auto* needs = new QHBoxLayout;
    needs->setSpacing(kSpace2);
    rows->addLayout(needs);
    m_class = new QComboBox(part);
    m_class->setObjectName(QStringLiteral("classChooser"));
    m_class->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_class->setMinimumContentsLength(16);
    m_class->setMinimumHeight(32);
    connect(m_class, &QComboBox::currentIndexChanged, this, &ClassPage::takeClass);
    row->addWidget(m_class);
    m_search = new QLineEdit(part);
    m_search->setObjectName(QStringLiteral("studentSearch"));
    m_search->setClearButtonEnabled(true);
    for (auto* clear : m_search->findChildren<QAbstractButton*>())
        text::bindTranslation(clear, [clear] { clear->setAccessibleName(tr("Clear the search")); });
    m_search->setFont(typeface(kBody));
    m_search->setFixedWidth(kSearchPx);
    connect(m_search, &QLineEdit::textChanged, this, &ClassPage::search);
    row->addWidget(m_search);
    m_found = new QLabel(part);
    m_found->setObjectName(QStringLiteral("studentsFound"));
    m_found->setForegroundRole(QPalette::PlaceholderText);
    row->addWidget(m_found);
    m_needs = new QLabel(part);
    m_needs->setObjectName(QStringLiteral("needs"));
    m_needs->setTextFormat(Qt::PlainText);
    m_needs->setFont(typeface(kBody, QFont::DemiBold));
    needs->addWidget(m_needs);
    m_need = new QButtonGroup(this);
    m_need->setExclusive(false);
    for (const Need need : kNeeds) {
        auto* button = new QPushButton(part);
        button->setProperty("kind", "segment");
        button->setCheckable(true);
        button->setAutoDefault(true);
        m_need->addButton(button, static_cast<int>(need));
        needs->addWidget(button);
    }
    needs->addStretch(1);
    // At most one filter is on. Without a filter all students are listed.
    connect(m_need, &QButtonGroup::idToggled, this, [this](int id, bool isOn) {
        for (QAbstractButton* button : m_need->buttons())
            if (isOn && m_need->id(button) != id) {
                const QSignalBlocker quiet(m_need);
                button->setChecked(false);
            }
        m_filter->setNeed(m_need->checkedId() < 0 ? Need::Nothing : static_cast<Need>(m_need->checkedId()));
        search();
    });
    row->addStretch(1);
    m_report = new QToolButton(part);
    m_report->setProperty("kind", "chooser");
    m_report->setPopupMode(QToolButton::InstantPopup);
    m_report->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_report->setMinimumHeight(36);
    m_report->setObjectName(QStringLiteral("classReport"));
    auto* menu = new QMenu(m_report);
    m_savePdf = menu->addAction(QString(), this, &ClassPage::pdfRequested);
    m_print = menu->addAction(QString(), this, &ClassPage::printRequested);
    m_saveCsv = menu->addAction(QString(), this, &ClassPage::askForFile);
    m_report->setMenu(menu);
    row->addWidget(m_report);
    m_assign = new QPushButton(part);
    m_assign->setObjectName(QStringLiteral("assignLessons"));
    m_assign->setProperty("kind", "filled");
    m_assign->setAutoDefault(true);
    connect(m_assign, &QPushButton::clicked, this, &ClassPage::assignRequested);
    row->addWidget(m_assign);
    return part;
}

QWidget* ClassPage::makeMatrix()
{
    m_stack = new QStackedWidget(this);
    auto* part = new QWidget(m_stack);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(kSpace2, 0, kSpace2, 0);
    column->setSpacing(kSpace1);
    m_table = new kit::ListTable(part);
    m_table->setObjectName(QStringLiteral("matrix"));
    m_table->installEventFilter(this);
    // Set before the model, so that the header learns of removed rows before the view asks for its width.
    auto* names = new NameHeads(m_table);
    names->setFixedWidth(kNamesPx);
    m_table->setVerticalHeader(names);
    m_table->setModel(m_filter);
    m_table->setItemDelegate(new ScoreCell(m_filter, m_model, m_table));
    m_table->setSelectionBehavior(QAbstractItemView::SelectItems);
    m_table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    QHeaderView* lessons = m_table->horizontalHeader();
    lessons->setSectionResizeMode(QHeaderView::Interactive);
    lessons->setDefaultSectionSize(kLessonPx);
    lessons->setFixedHeight(kHeadPx);
    lessons->setSortIndicatorClearable(true);
    lessons->setSortIndicator(-1, Qt::AscendingOrder);
    connect(names, &QHeaderView::sectionClicked, this, [this](int row) {
        const QModelIndex source = m_filter->mapToSource(m_filter->index(row, 0));
        emit studentRequested(m_model->overview().students[static_cast<std::size_t>(source.row())].id.value);
    });
    connect(m_table, &QTableView::clicked, this, &ClassPage::takeCell);
    // Handles keys only, because a double click has already been handled as a click.
    connect(m_table, &QTableView::activated, this, [this](const QModelIndex& index) {
        if (m_table->isByKey())
            takeCell(index);
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentColumnChanged, this,
            [this](const QModelIndex& now) {
                if (const auto lesson = ClassModel::lessonOf(now.column()))
                    m_lesson->setCurrentIndex(static_cast<int>(*lesson));
            });
    connect(lessons, &QHeaderView::sectionClicked, this, [this](int clicked) {
        if (const auto lesson = ClassModel::lessonOf(clicked))
            m_lesson->setCurrentIndex(static_cast<int>(*lesson));
    });
    column->addWidget(m_table, 1);
    m_legend = new QLabel(part);
    m_said = new QLabel(part);
    m_said->setObjectName(QStringLiteral("said"));
    m_said->hide();
    for (QLabel* words : {m_legend, m_said}) {
        words->setTextFormat(Qt::PlainText);
        words->setFont(typeface(kSmall));
        words->setForegroundRole(QPalette::PlaceholderText);
        words->setMinimumWidth(1);
        words->setWordWrap(true);
        column->addWidget(words);
    }
    m_stack->addWidget(part);

    m_stack->addWidget(makeEmpty());
    return m_stack;
}

/// Makes the page for a class without students.
QWidget* ClassPage::makeEmpty()
{
    auto* part = new QWidget(m_stack);
    auto* column = new QVBoxLayout(part);
    column->setSpacing(kSpace4);
    column->addStretch(1);
    m_empty = new QLabel(part);
    m_empty->setObjectName(QStringLiteral("classEmpty"));
    m_empty->setTextFormat(Qt::PlainText);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    column->addWidget(m_empty);
    m_people = new QPushButton(part);
    m_people->setObjectName(QStringLiteral("enterPeople"));
    m_people->setProperty("kind", "filled");
    m_people->setAutoDefault(true);
    connect(m_people, &QPushButton::clicked, this, &ClassPage::peopleRequested);
    column->addWidget(m_people, 0, Qt::AlignHCenter);
    column->addStretch(1);
    return part;
}

void ClassPage::setMayEnter(bool may)
{
    m_mayEnter = may;
    updateNeeds();
}

QWidget* ClassPage::makeCharts()
{
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(kSpace2, 0, kSpace2, 0);
    column->setSpacing(kSpace2);
    auto* head = new QHBoxLayout;
    head->setSpacing(kSpace2);
    m_lessonWord = new QLabel(part);
    m_lessonWord->setFont(typeface(kBody, QFont::DemiBold));
    m_lesson = new QComboBox(part);
    m_lesson->setObjectName(QStringLiteral("lessonChooser"));
    m_lesson->setSizeAdjustPolicy(QComboBox::AdjustToContents);  // a cut-off title would have no ellipsis
    m_lesson->setMinimumSize(kLeastChooserPx, 32);
    m_lessonWord->setBuddy(m_lesson);
    connect(m_lesson, &QComboBox::currentIndexChanged, this, &ClassPage::takeLesson);
    head->addWidget(m_lessonWord);
    head->addWidget(m_lesson);
    head->addStretch(1);
    column->addLayout(head);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace4);
    const auto panel = [&](const char* name) {
        auto* frame = new QFrame(part);
        frame->setProperty("kind", "card");
        auto* inside = new QVBoxLayout(frame);
        inside->setContentsMargins(kSpace1, kSpace1, kSpace1, kSpace1);
        auto* made = new charts::ChartPanel(frame);
        made->setObjectName(QLatin1String(name));
        inside->addWidget(made);
        row->addWidget(frame, 1);
        return made;
    };
    m_distribution = panel("distribution");
    m_learning = panel("learning");
    m_difficulty = panel("difficulty");
    column->addLayout(row, 1);
    return part;
}

void ClassPage::setClasses(const QList<database::SchoolClass>& classes)
{
    m_isListed = true;
    m_whyNot = nullptr;
    listClasses(classes);
}

void ClassPage::listClasses(const QList<database::SchoolClass>& classes)
{
    m_classes = classes;
    const database::ClassId before = chosenClass();
    fillClasses();
    if (chosenClass() != before)
        takeClass();
    retell();
}

/// Requests the selected class. Clears the page, so that results of another class are not shown under its name.
void ClassPage::takeClass()
{
    if (!isRead())
        clear();
    if (chosenClass().value != 0)
        readAgain();
}

void ClassPage::refuse(std::function<QString()> why)
{
    if (isRead())
        return;
    m_whyNot = std::move(why);
    updateEmpty();
    announce(*m_empty);
}

void ClassPage::clear()
{
    m_model->setOverview({}, {});
    m_whyNot = nullptr;
    m_search->clear();
    for (QAbstractButton* button : m_need->buttons())
        button->setChecked(false);
    fillLessons();
    takeLesson();
    updateNeeds();
    say({});
}

void ClassPage::fillClasses()
{
    const database::ClassId kept = chosenClass();
    const QSignalBlocker quiet(m_class);
    m_class->clear();
    for (const database::SchoolClass& one : m_classes) {
        //: %1: name of a class; %2: how many students
        m_class->addItem(tr("%1 (%2)").arg(QString::fromStdString(one.name)).arg(one.students),
                         static_cast<qlonglong>(one.id.value));
        if (one.id == kept)
            m_class->setCurrentIndex(m_class->count() - 1);
    }
}

void ClassPage::setOverview(const database::ClassOverview& overview, const QDateTime& now)
{
    const QString before = chosenLesson();
    const bool wasEmpty = m_model->rowCount() == 0;
    if (overview.id == m_model->overview().id) {
        const Place seen = place();
        m_model->setOverview(overview, now);
        fitColumns();
        goTo(seen);
    } else {
        m_model->setOverview(overview, now);
        m_search->clear();
        for (QAbstractButton* button : m_need->buttons())
            button->setChecked(false);
        fitColumns();
    }
    fillLessons();
    updateNeeds();
    say({});
    if (wasEmpty && isVisible())
        m_table->setFocus();
    if (chosenLesson() != before || chosenLesson().isEmpty())
        takeLesson();
}

ClassPage::Place ClassPage::place() const
{
    Place made{{}, {}, {m_table->horizontalScrollBar()->value(), m_table->verticalScrollBar()->value()}};
    const QModelIndex current = m_filter->mapToSource(m_table->currentIndex());
    if (!current.isValid())
        return made;
    made.student = m_model->overview().students[static_cast<std::size_t>(current.row())].id;
    if (const auto lesson = ClassModel::lessonOf(current.column()))
        made.lesson = m_model->overview().lessons[*lesson];
    return made;
}

void ClassPage::goTo(const Place& place)
{
    const std::vector<MatrixStudent>& students = m_model->overview().students;
    const std::vector<std::string>& lessons = m_model->overview().lessons;
    const auto student = std::find_if(students.begin(), students.end(),
                                      [&place](const MatrixStudent& one) { return one.id == place.student; });
    const auto lesson = std::find(lessons.begin(), lessons.end(), place.lesson);
    if (student != students.end() && (lesson != lessons.end() || place.lesson.empty())) {
        const QSignalBlocker quiet(m_lesson);  // the charts remain those of the selected lesson
        const int column = place.lesson.empty() ? ClassModel::kLast
                                                : ClassModel::kFirstLesson + static_cast<int>(lesson - lessons.begin());
        const QString charted = chosenLesson();
        m_table->setCurrentIndex(
            m_filter->mapFromSource(m_model->index(static_cast<int>(student - students.begin()), column)));
        m_lesson->setCurrentIndex(m_lesson->findData(charted));
    }
    m_table->doItemsLayout();
    m_table->horizontalScrollBar()->setValue(place.scrolled.x());
    m_table->verticalScrollBar()->setValue(place.scrolled.y());
}

void ClassPage::readAgain()
{
    m_whyNot = nullptr;
    updateEmpty();
    if (chosenClass().value == 0)
        emit listRequested();
    else
        emit classChosen(chosenClass().value);
}

void ClassPage::setAssignments(const QList<database::ClassAssignment>& given)
{
    m_model->setAssignments(given);
    m_table->horizontalHeader()->setFixedHeight(kHeadPx + (m_model->hasDueDates() ? kDuePx : 0));
    m_filter->invalidate();
    updateNeeds();
}

void ClassPage::setLessonTitles(const text::LessonTitles& titles)
{
    m_titles = titles;
    m_model->setTitles(titles);
    fillLessons();
}

void ClassPage::setResults(const database::LessonResults& results, int passMarkTenths,
                           const std::map<std::string, QString>& criteria)
{
    // Another lesson may have been selected since the request.
    if (QString::fromStdString(results.lessonId) != chosenLesson())
        return;
    m_results = results;
    m_passMarkTenths = passMarkTenths;
    m_criteria = criteria;
    drawCharts();
}

database::ClassId ClassPage::chosenClass() const
{
    return {m_class->currentData().toLongLong()};
}

QString ClassPage::chosenLesson() const
{
    return m_lesson->currentData().toString();
}

void ClassPage::fillLessons()
{
    // After a change of class, selects the same lesson as before.
    if (!chosenLesson().isEmpty())
        m_lastLesson = chosenLesson();
    const QString kept = m_lastLesson;
    const QSignalBlocker quiet(m_lesson);
    m_lesson->clear();
    const std::vector<std::string>& lessons = m_model->overview().lessons;
    for (std::size_t k = 0; k < lessons.size(); ++k) {
        // Shows the results beside each title, so that teachers see the difficult lessons before they open a chart.
        const ClassModel::Passed of = m_model->passed(k);
        const QString title = text::lessonTitle(m_titles, lessons[k]);
        m_lesson->addItem(
            of.tried == 0
                ? title
                //: %1: a lesson; %2 of the %3 who tried it
                : tr("%1 (%2 of %3 passed)").arg(title, QString::number(of.passed), QString::number(of.tried)),
            QString::fromStdString(lessons[k]));
        if (m_lesson->itemData(m_lesson->count() - 1).toString() == kept)
            m_lesson->setCurrentIndex(m_lesson->count() - 1);
    }
    m_lesson->setEnabled(m_lesson->count() > 0);
}

void ClassPage::takeLesson()
{
    m_results = {};
    m_passMarkTenths = 0;
    drawCharts();
    if (!chosenLesson().isEmpty())
        emit lessonChosen(chosenLesson());
}

void ClassPage::takeCell(const QModelIndex& index)
{
    const QModelIndex source = m_filter->mapToSource(index);
    if (!source.isValid())
        return;
    const auto& student = m_model->overview().students[static_cast<std::size_t>(source.row())];
    const database::MatrixCell* cell = m_model->cell(source);
    if (cell == nullptr) {
        if (!student.lastAttemptUtc.empty())
            emit studentRequested(student.id.value);
    } else if (cell->attempts + cell->withoutScore > 0) {
        const std::string& lesson = m_model->overview().lessons[*ClassModel::lessonOf(source.column())];
        emit attemptsRequested(student.id.value, QString::fromStdString(lesson));
    }
}

void ClassPage::forget()
{
    m_isListed = false;
    listClasses({});
    m_lastLesson.clear();
}

void ClassPage::updateNeeds()
{
    // Not the sum of the counts, because a student may have several needs.
    const int all = m_model->rowCount() - m_model->count(Need::Nothing);
    for (const Need need : kNeeds) {
        const int count = m_model->count(need);
        QAbstractButton* button = m_need->button(static_cast<int>(need));
        //: %1: how many; %2: "stuck"
        button->setText(tr("%1 %2").arg(count).arg(needWord(need)));
        button->setVisible(count > 0);
        if (count == 0)  // otherwise the list would be empty, and the filter could not be switched off
            button->setChecked(false);
    }
    const auto explain = [this](Need need, const QString& words) {
        QAbstractButton* button = m_need->button(static_cast<int>(need));
        button->setToolTip(kit::brokenIntoLines(words));
        button->setAccessibleName(button->text());
        button->setAccessibleDescription(words);
    };
    explain(Need::NoneLeft,
            tr("Show who has no attempts left at a lesson that is not passed. More can be allowed under "
               "Assign lessons."));
    explain(Need::Stuck, tr("Show who made three attempts in a row at a lesson without passing, and without getting "
                            "better by five points"));
    explain(Need::NeverLoggedIn, tr("Show who has never logged in"));
    explain(Need::Late, tr("Show who has not passed a lesson that is overdue"));
    explain(Need::NotBegun, tr("Show who has logged in and has no graded attempt yet"));
    const bool hasStudents = m_model->rowCount() > 0;
    m_needs->setText(!hasStudents ? QString()
                     : all == 0   ? tr("Nobody needs you just now")
                                //: Students who need their teacher; numbers of each kind follow
                                : tr("%n need(s) you:", nullptr, all));
    m_stack->setCurrentIndex(hasStudents ? 0 : 1);
    updateEmpty();
    m_class->setVisible(!m_classes.isEmpty());
    m_charts->setVisible(m_lesson->count() > 0);
    m_report->setVisible(!m_classes.isEmpty());
    m_report->setEnabled(hasStudents);
    m_search->setVisible(hasStudents);
    search();
    m_assign->setVisible(!m_classes.isEmpty());
}

void ClassPage::search()
{
    m_filter->setWords(m_search->text());
    m_found->setText(m_search->text().trimmed().isEmpty() ? QString()
                                                          : tr("%Ln student(s)", nullptr, m_filter->rowCount()));
}

void ClassPage::updateEmpty()
{
    m_people->setVisible(m_mayEnter && isRead());
    if (!isRead())
        m_empty->setText(
            m_whyNot && !m_isListed
                //: %1: that the classes could not be read, and why
                ? tr("%1 F5 reads the classes again; Cusp tries it every ten seconds, too.").arg(m_whyNot())
                : m_whyNot
                      //: %1: that a class could not be read, and why
                      ? tr("%1 F5 reads the class again; Cusp tries it every ten seconds, too.").arg(m_whyNot())
                      : m_isListed ? tr("The class is being read …") : tr("The classes are being read …"));
    else if (m_classes.isEmpty())
        m_empty->setText(
            m_mayEnter
                ? tr("There is no class yet. Make one, and enter its teachers and students: then you see here who "
                     "needs help, and how everybody does at every lesson.")
                : tr("Here you will see your classes: who needs you, and how everybody does at every lesson. "
                     "An administrator gives you a class."));
    else
        m_empty->setText(m_mayEnter
                             ? tr("Nobody is in this class yet. Enter its students, one by one or from a list.")
                             : tr("Nobody is in this class yet. Students are entered by an administrator, one by one "
                                  "or from a list."));
}

void ClassPage::drawCharts()
{
    //: %1: a class; %2: a lesson
    const QString of = tr("%1, %2").arg(QString::fromStdString(m_model->overview().name),
                                        text::lessonTitle(m_titles, m_results.lessonId));
    const auto show = [&](charts::ChartPanel* panel, charts::Chart chart) {
        chart.of = of;
        panel->setChart(chart);
    };
    show(m_distribution, distributionChart(m_results, m_passMarkTenths));
    show(m_learning, learningChart(m_results, m_passMarkTenths));
    show(m_difficulty, difficultyChart(m_results, m_criteria));
}

/// Divides the width among the lessons. No column is narrower than its title needs.
void ClassPage::fitColumns()
{
    const int lessons = static_cast<int>(m_model->overview().lessons.size());
    QHeaderView* columns = m_table->horizontalHeader();
    if (lessons == 0)
        return;
    const int last = QFontMetrics(typeface(kBody)).horizontalAdvance(QStringLiteral("yesterday")) + kSpace6;
    columns->resizeSection(ClassModel::kLast, last);
    const int room = m_table->width() - kNamesPx - last - kSpace6;
    const int each = std::clamp(room / lessons, kLessonPx, 2 * kLessonPx);
    // A title wraps between words, so its longest word must fit.
    static const QRegularExpression gaps(QStringLiteral("\\s+"));
    const QFontMetrics letters(typeface(kBody, QFont::DemiBold));
    for (int k = 0; k < lessons; ++k) {
        const int column = ClassModel::kFirstLesson + k;
        int widest = each;
        for (const QString& word : m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().split(gaps))
            widest = std::max(widest, letters.horizontalAdvance(word) + kSpace6 + kSpace2);
        columns->resizeSection(column, std::min(widest, 2 * kLessonPx));
    }
}

void ClassPage::say(std::function<QString()> words)
{
    m_saying = std::move(words);
    updateSaying();
    if (m_saying)
        announce(*m_said);
}

/// Shows the message. Its tooltip has the whole text, because a path may be longer than the room.
void ClassPage::updateSaying()
{
    m_said->setText(m_saying ? m_saying() : QString());
    m_said->setToolTip(m_saying ? brokenIntoLines(m_said->text()) : QString());
    m_said->setVisible(!m_said->text().isEmpty());
}

bool ClassPage::saveTable(const QString& path)
{
    return save(path, csv());
}

QByteArray ClassPage::csv() const
{
    return charts::csv(table());
}

bool ClassPage::save(const QString& path, const QByteArray& csv)
{
    QSaveFile file(path);
    const bool isWritten = kit::openForOwner(file) && file.write(csv) == csv.size() && file.flush() && file.commit();
    const QString name = QDir::toNativeSeparators(path);
    say([isWritten, name, why = file.errorString()] {
        return isWritten ? tr("Saved: %1").arg(name)
                         //: %2: the system's own words
                         : tr("%1 could not be written (%2). Try another folder.").arg(name, why);
    });
    return isWritten;
}

void ClassPage::askForFile()
{
    auto* dialog =
        new kit::FileDialog(this, tr("Save the matrix"), kit::documentsFolder(), QStringLiteral("CSV (*.csv)"));
    connect(dialog, &QFileDialog::fileSelected, this, &ClassPage::tableRequested);
    dialog->askWhere(QString::fromStdString(m_model->overview().name), QStringLiteral("csv"));
}

void ClassPage::retell()
{
    setTitle(tr("Class"));
    updateSaying();
    kit::nameInput(m_class, tr("Class"));
    m_search->setPlaceholderText(tr("Search: a student"));
    m_search->setAccessibleName(m_search->placeholderText());
    m_lessonWord->setText(tr("How the class does at"));
    kit::nameInput(m_lesson, tr("Lesson whose charts are shown"));
    m_table->setAccessibleName(tr("Best scores, students by lessons"));
    m_assign->setText(tr("Assign lessons"));
    m_assign->setAccessibleName(m_assign->text());
    //: Where people are entered and classes are made
    m_people->setText(tr("People and classes"));
    m_people->setAccessibleName(m_people->text());
    m_report->setText(tr("Report"));
    m_report->setAccessibleName(m_report->text());
    m_savePdf->setText(tr("Save as PDF …"));
    m_print->setText(tr("Print …"));
    m_saveCsv->setText(tr("Save the matrix as a table (CSV) …"));
    m_legend->setText(tr("Best score of each student; a tick: passed; ▲: overdue, or no attempts left; ⚠: does "
                         "not match its recording. A heading sorts, once more the other way, then by name. A cell "
                         "opens the attempts."));
    m_legend->setToolTip(kit::brokenIntoLines(m_legend->text()));
    m_model->retell();
    fitColumns();
    fillClasses();
    fillLessons();
    updateNeeds();
    drawCharts();
}

void ClassPage::changeEvent(QEvent* event)
{
    Page::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retell();
}

bool ClassPage::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_table && event->type() == QEvent::Resize)
        fitColumns();
    return Page::eventFilter(watched, event);
}

void ClassPage::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    m_table->setFocus();
    readAgain();
}

}  // namespace ui::people
