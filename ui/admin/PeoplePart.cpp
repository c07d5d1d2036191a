// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/admin/PeoplePart.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <QClipboard>
#include <QCollator>
#include <QComboBox>
#include <QDateTime>
#include <QFrame>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QStyleHints>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/admin/AdminWords.h"
#include "ui/admin/SecondThought.h"
#include "ui/people/ListTable.h"
#include "ui/people/PeopleWords.h"
#include "ui/people/WordFilter.h"
#include "ui/shell/ScrollPane.h"
#include "ui/shell/Theme.h"
#include "ui/study/FormInputs.h"
#include "ui/text/EveryLanguage.h"

namespace ui::admin {
namespace {

using namespace ui::shell;
using database::Person;
using database::Role;

enum Column { kName, kUsername, kRole, kClasses, kLastLogin, kState, kColumns };
enum DataRole { kId = Qt::UserRole + 1, kSortBy };

constexpr int kFormPx = 340;
constexpr int kClassListPx = 110;
constexpr int kTickPx = 28;
constexpr int kMostFittedPx = 320;  ///< of a column, for the sake of one who is in many classes
constexpr int kSoonMs = 100;        ///< what takes longer is told
constexpr std::array kRoles{Role::Student, Role::Instructor, Role::Admin};

/// As high as the fields leave it room for, and at least three lines.
class TickList final : public QListWidget
{
public:
    using QListWidget::QListWidget;
    [[nodiscard]] QSize sizeHint() const override { return minimumSizeHint(); }
    [[nodiscard]] QSize minimumSizeHint() const override
    {
        return {QListWidget::minimumSizeHint().width(), kClassListPx};
    }
};

QPushButton* button(const char* kind, const char* name, QWidget* parent)
{
    auto* made = new QPushButton(parent);
    made->setProperty("kind", kind);
    made->setObjectName(QLatin1String(name));
    made->setAutoDefault(false);
    return made;
}

QLineEdit* input(const char* name, QWidget* parent)
{
    constexpr int kLongest = 200;
    auto* made = new QLineEdit(parent);
    made->setObjectName(QLatin1String(name));
    made->setFont(typeface(kBody));
    made->setMaxLength(kLongest);
    return made;
}

}  // namespace

PeoplePart::PeoplePart(QWidget* parent) : QWidget(parent)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSpace4);
    row->addWidget(makeList(), 1);
    row->addWidget(makeForm());
    text::inEveryLanguage(this, [this] { speak(); });
    choose(0);
}

QWidget* PeoplePart::makeList()
{
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace2);
    auto* head = new QHBoxLayout;
    m_search = input("peopleSearch", side);
    m_search->setObjectName(QStringLiteral("peopleSearch"));
    m_search->setClearButtonEnabled(true);
    for (auto* clear : m_search->findChildren<QAbstractButton*>())
        text::inEveryLanguage(clear, [clear] { clear->setAccessibleName(tr("Clear the search")); });
    m_count = new QLabel(side);
    m_count->setObjectName(QStringLiteral("peopleCount"));
    m_count->setForegroundRole(QPalette::PlaceholderText);
    m_new = button("filled", "newPerson", side);
    head->addWidget(m_search, 1);
    head->addWidget(m_count);
    head->addWidget(m_new);
    column->addLayout(head);
    m_rows = new QStandardItemModel(0, kColumns, side);
    m_rows->setSortRole(kSortBy);
    m_shown = new people::WordFilter(side);
    m_shown->setSourceModel(m_rows);
    m_shown->setSortRole(kSortBy);
    m_shown->setSortLocaleAware(true);
    m_table = new people::ListTable(side);
    m_table->setObjectName(QStringLiteral("people"));
    m_table->setModel(m_shown);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->sortByColumn(kName, Qt::AscendingOrder);
    column->addWidget(m_table, 1);
    connect(m_search, &QLineEdit::textChanged, this, &PeoplePart::filter);
    connect(m_new, &QPushButton::clicked, this, [this] {
        select(0);
        m_username->setFocus();
    });
    // A row that becomes the current one when the table gets the focus was chosen by nobody.
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        if (const QModelIndexList rows = m_table->selectionModel()->selectedRows(kName); !rows.isEmpty())
            choose(rows.front().data(kId).toLongLong());
    });
    connect(m_table, &QAbstractItemView::activated, this,
            [this](const QModelIndex& index) { m_table->selectRow(index.row()); });
    return side;
}

QWidget* PeoplePart::makeForm()
{
    auto* form = new QWidget(this);
    auto* column = new QVBoxLayout(form);
    column->setContentsMargins(0, 0, kSpace2, 0);
    column->setSpacing(kSpace2);
    m_title = study::formWords({}, kTitle, QFont::DemiBold, QPalette::WindowText, form);
    m_title->setTextFormat(Qt::PlainText);
    column->addWidget(m_title);
    m_codeCard = new QFrame(form);
    m_codeCard->setProperty("kind", "card");
    auto* code = new QVBoxLayout(m_codeCard);
    m_codeWords = study::formWords({}, kBody, QFont::Normal, QPalette::WindowText, m_codeCard);
    m_codeWords->setTextFormat(Qt::PlainText);
    m_code = new QLabel(m_codeCard);
    m_code->setObjectName(QStringLiteral("oneTimeCode"));
    m_code->setFont(typeface(kTitle, QFont::DemiBold));
    m_code->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_copy = button("", "copyCode", m_codeCard);
    code->addWidget(m_codeWords);
    code->addWidget(m_code);
    code->addWidget(m_copy, 0, Qt::AlignLeft);
    column->addWidget(m_codeCard);
    m_username = input("personUsername", form);
    m_given = input("personGiven", form);
    m_family = input("personFamily", form);
    m_role = study::choiceInput({}, form);
    m_role->setObjectName(QStringLiteral("personRole"));
    m_role->setMinimumHeight(m_username->sizeHint().height());
    // What a field is must be readable when it is filled as well.
    const auto headed = [form, column](QWidget* field) {
        auto* word = study::formWords({}, kSmall, QFont::Normal, QPalette::PlaceholderText, form);
        word->setBuddy(field);
        auto* both = new QVBoxLayout;
        both->setSpacing(2);
        both->addWidget(word);
        both->addWidget(field);
        column->addLayout(both);
        return word;
    };
    m_usernameWord = headed(m_username);
    m_givenWord = headed(m_given);
    m_familyWord = headed(m_family);
    m_roleWord = headed(m_role);
    m_classesWord = study::formWords({}, kSmall, QFont::Normal, QPalette::PlaceholderText, form);
    column->addWidget(m_classesWord);
    m_classList = new TickList(form);
    m_classList->setObjectName(QStringLiteral("personClasses"));
    m_classList->setProperty("kind", "ticks");
    m_classesWord->setBuddy(m_classList);
    column->addWidget(m_classList, 1);
    auto* classes = new QHBoxLayout;
    m_className = input("className", form);
    m_addClass = button("", "addClass", form);
    m_renameClass = button("", "renameClass", form);
    classes->addWidget(m_addClass);
    classes->addWidget(m_renameClass);
    classes->addStretch(1);
    column->addWidget(m_className);
    column->addLayout(classes);
    auto* whole = new QWidget(this);
    whole->setFixedWidth(kFormPx);
    auto* stack = new QVBoxLayout(whole);
    stack->setContentsMargins(0, 0, 0, 0);
    m_pane = new ScrollPane(form, QPalette::Window, whole);
    stack->addWidget(m_pane, 1);
    // Answers stand beside the buttons that they answer, however far the form is scrolled.
    m_fault = study::faultLabel(whole);
    m_fault->setObjectName(QStringLiteral("personFault"));
    m_said = study::formWords({}, kBody, QFont::Normal, QPalette::WindowText, whole);
    m_said->setObjectName(QStringLiteral("personSaid"));
    m_said->setTextFormat(Qt::PlainText);
    stack->addWidget(makeAside(whole));
    stack->addWidget(m_fault);
    stack->addWidget(m_said);
    m_save = button("filled", "savePerson", whole);
    m_reset = button("", "resetPassword", whole);
    m_keepPassword = button("", "keepPassword", whole);
    m_disable = button("", "disablePerson", whole);
    // The button above stays where it is when they come.
    QSizePolicy keepsPlace = m_reset->sizePolicy();
    keepsPlace.setRetainSizeWhenHidden(true);
    m_reset->setSizePolicy(keepsPlace);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_reset);
    buttons->addWidget(m_keepPassword);
    buttons->addWidget(m_disable);
    buttons->addStretch(1);
    stack->addWidget(m_save, 0, Qt::AlignLeft);
    stack->addLayout(buttons);
    connect(m_save, &QPushButton::clicked, this, &PeoplePart::submit);
    for (QLineEdit* one : {m_username, m_given, m_family})
        connect(one, &QLineEdit::returnPressed, this, &PeoplePart::submit);
    const auto touch = [this] {
        m_isTouched = true;
        endThought();
    };
    for (QLineEdit* one : {m_username, m_given, m_family})
        connect(one, &QLineEdit::textEdited, this, touch);
    connect(m_role, &QComboBox::activated, this, touch);
    connect(m_classList, &QListWidget::itemChanged, this, touch);
    connect(m_reset, &QPushButton::clicked, this, &PeoplePart::askToReset);
    m_thought = new SecondThought(*this);
    const auto keep = [this] {
        m_thought->end();
        m_said->clear();
        showForm();
        m_reset->setFocus();
    };
    connect(m_keepPassword, &QPushButton::clicked, this, keep);
    connect(m_thought, &SecondThought::withdrawn, this, keep);
    connect(m_disable, &QPushButton::clicked, this, &PeoplePart::toggleDisabled);
    connect(m_copy, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(m_code->text()); });
    const auto addClass = [this] {
        endThought();
        const QString wanted = m_className->text().trimmed();
        for (int k = 0; k < m_classList->count(); ++k)
            if (QListWidgetItem* const there = m_classList->item(k); there->text() == wanted) {
                there->setCheckState(Qt::Checked);
                m_classList->scrollToItem(there);
                m_className->clear();
                study::showFault(m_fault, {});
                //: %1: the name of a class
                m_said->setText(tr("There is a class %1 already. It is ticked above.").arg(wanted));
                return;
            }
        if (!wanted.isEmpty())
            emit classWanted(wanted);
        // Whoever adds a class while he enters or changes somebody means him to be in it.
        m_isTouched = m_isTouched || !m_className->text().trimmed().isEmpty();
        m_classAdded = m_className->text().trimmed().toStdString();
        m_className->clear();
    };
    connect(m_addClass, &QPushButton::clicked, this, addClass);
    connect(m_className, &QLineEdit::returnPressed, this, addClass);
    connect(m_renameClass, &QPushButton::clicked, this, [this] {
        endThought();
        const QListWidgetItem* item = m_classList->currentItem();
        if (const QString name = m_className->text().trimmed(); item != nullptr && !name.isEmpty())
            emit classNameWanted(item->data(kId).toLongLong(), name);
    });
    const auto tellRename = [this] {
        m_renameClass->setEnabled(m_classList->currentItem() != nullptr && !m_className->text().trimmed().isEmpty());
        m_addClass->setEnabled(!m_className->text().trimmed().isEmpty());
    };
    connect(m_className, &QLineEdit::textChanged, this, tellRename);
    connect(m_classList, &QListWidget::currentRowChanged, this, tellRename);
    tellRename();
    return whole;
}

/// What stood half filled in when another row was chosen.
QWidget* PeoplePart::makeAside(QWidget* parent)
{
    m_asideRow = new QWidget(parent);
    auto* column = new QVBoxLayout(m_asideRow);
    column->setContentsMargins(0, 0, 0, 0);
    m_asideWords = study::formWords({}, kSmall, QFont::Normal, QPalette::WindowText, m_asideRow);
    m_asideWords->setObjectName(QStringLiteral("personAside"));
    m_asideWords->setTextFormat(Qt::PlainText);
    auto* back = button("", "personAsideBack", m_asideRow);
    column->addWidget(m_asideWords);
    column->addWidget(back, 0, Qt::AlignLeft);
    connect(back, &QPushButton::clicked, this, &PeoplePart::bringBack);
    text::inEveryLanguage(back, [back] {
        back->setText(tr("Bring the changes back"));
        back->setAccessibleName(back->text());
    });
    return m_asideRow;
}

void PeoplePart::speak()
{
    const auto name = [](QLineEdit* one, const QString& words) {
        one->setPlaceholderText(words);
        one->setToolTip(words);
        one->setAccessibleName(words);
    };
    name(m_search, tr("Search: a name, a class, a role"));
    for (const auto& [field, word, words] :
         {std::tuple(m_username, m_usernameWord, tr("Name to log in with")),
          std::tuple(m_given, m_givenWord, tr("Given name")), std::tuple(m_family, m_familyWord, tr("Family name"))}) {
        field->setAccessibleName(words);
        word->setText(words);
    }
    m_roleWord->setText(tr("Role"));
    name(m_className, tr("Name of a class"));
    m_table->setAccessibleName(tr("People"));
    m_rows->setHorizontalHeaderLabels(
        {tr("Name"), tr("Login"), tr("Role"), tr("Classes"), tr("Last login"), tr("State")});
    m_new->setText(tr("New person"));
    m_classesWord->setText(tr("Classes"));
    m_classList->setAccessibleName(tr("Classes"));
    m_addClass->setText(tr("Add"));
    m_addClass->setToolTip(tr("Add a class of this name"));
    m_renameClass->setText(tr("Rename"));
    m_renameClass->setToolTip(tr("Give this name to the class that is chosen above"));
    m_keepPassword->setText(tr("Keep it"));
    m_keepPassword->setAccessibleName(tr("Keep the password"));
    m_reset->setToolTip(brokenIntoLines(tr("Take the password away and give a one-time code in its place")));
    m_copy->setText(tr("Copy"));
    m_new->setAccessibleName(m_new->text());
    m_addClass->setAccessibleName(m_addClass->toolTip());
    m_renameClass->setAccessibleName(tr("Rename the class"));
    m_copy->setAccessibleName(tr("Copy the one-time code"));
    const QSignalBlocker quiet(m_role);
    const int role = std::max(0, m_role->currentIndex());
    m_role->clear();
    for (const Role one : kRoles)
        m_role->addItem(roleWord(one));
    m_role->setCurrentIndex(role);
    study::nameInput(m_role, tr("Role"));
    fill();
    showForm();
}

QString PeoplePart::stateOf(const Person& person) const
{
    if (person.disabled)
        return tr("disabled");
    if (person.hasPassword)
        return tr("can log in");
    if (m_codes.contains(person.id.value))
        return tr("has a one-time code, shown here");
    return person.codeUntilUtc >= QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString()
               ? tr("has a one-time code")
               : tr("needs a one-time code");
}

void PeoplePart::fill()
{
    const QSignalBlocker quiet(m_table->selectionModel());
    m_rows->setRowCount(0);
    int select = -1;
    for (const Person& person : m_people) {
        QStringList classes;
        for (const database::SchoolClass& one : m_classes)
            if (std::find(person.classes.begin(), person.classes.end(), one.id) != person.classes.end())
                classes << QString::fromStdString(one.name);
        const QString family = QString::fromStdString(person.familyName);
        const QStringList words{
            QString::fromStdString(person.fullName()), QString::fromStdString(person.username), roleWord(person.role),
            classes.join(QStringLiteral(", ")),        people::when(person.lastLoginUtc),       stateOf(person)};
        QList<QStandardItem*> row;
        for (const QString& one : words) {
            row << new QStandardItem(one);
            row.back()->setData(one, kSortBy);
            row.back()->setToolTip(brokenIntoLines(one));
        }
        row[kName]->setData(QVariant::fromValue<qint64>(person.id.value), kId);
        row[kName]->setData(family + u' ' + words[kName], kSortBy);
        row[kLastLogin]->setData(QString::fromStdString(person.lastLoginUtc), kSortBy);
        m_rows->appendRow(row);
        if (person.id.value == m_chosen)
            select = m_rows->rowCount() - 1;
    }
    fitColumns();
    if (select >= 0)
        m_table->setCurrentIndex(m_shown->mapFromSource(m_rows->index(select, kName)));
    filter();
}

/// The table measures its first rows alone: of thousands none of them may be an instructor. The one of most letters is
/// measured in every column, of all persons, whoever is searched for.
void PeoplePart::fitColumns()
{
    m_shown->setWords({});
    m_table->resizeColumnsToContents();
    for (int column = 0; column < m_rows->columnCount(); ++column) {
        int longest = -1;
        qsizetype letters = 0;
        for (int row = 0; row < m_rows->rowCount(); ++row)
            if (const qsizetype here = m_rows->item(row, column)->text().size(); here > letters) {
                letters = here;
                longest = row;
            }
        if (longest < 0)
            continue;
        const QModelIndex index = m_shown->mapFromSource(m_rows->index(longest, column));
        const int wanted = std::min(m_table->sizeHintForIndex(index).width() + 1, kMostFittedPx);
        m_table->setColumnWidth(column, std::max(m_table->columnWidth(column), wanted));
    }
}

void PeoplePart::filter()
{
    // Whom the form shows stays there: of a row that is hidden the table chooses the neighbour. When the search no
    // longer hides him he is marked again.
    const QSignalBlocker quiet(m_table->selectionModel());
    m_shown->setWords(m_search->text());
    m_count->setText(tr("%Ln person(s)", nullptr, m_shown->rowCount()));
    m_table->clearSelection();
    for (int row = 0; row < m_shown->rowCount() && m_chosen != 0; ++row)
        if (m_shown->index(row, kName).data(kId).toLongLong() == m_chosen)
            m_table->selectRow(row);
    m_table->viewport()->update();
}

void PeoplePart::setPeople(const QList<Person>& people, const QList<database::SchoolClass>& classes)
{
    m_people = people;
    m_classes = classes;
    for (const Person& person : people)
        if (person.hasPassword)  // the code was used
            m_codes.remove(person.id.value);
    fill();
    showForm();
}

const Person* PeoplePart::find(qint64 person) const
{
    const auto found =
        std::find_if(m_people.begin(), m_people.end(), [person](const Person& one) { return one.id.value == person; });
    return found == m_people.end() ? nullptr : &*found;
}

void PeoplePart::choose(qint64 person)
{
    if (m_chosen == person && person != 0)
        return;
    putAside();
    m_chosen = person;
    m_isTouched = false;
    m_sinceSubmitted.invalidate();
    m_said->clear();
    m_thought->end();
    study::showFault(m_fault, {});
    if (person == 0) {
        for (QLineEdit* one : {m_username, m_given, m_family})
            one->clear();
        // Nobody becomes an admin because one was looked at before.
        m_role->setCurrentIndex(0);
        m_classList->clear();
    }
    showForm();
}

void PeoplePart::select(qint64 person)
{
    for (int row = 0; row < m_shown->rowCount(); ++row)
        if (m_shown->index(row, kName).data(kId).toLongLong() == person) {
            m_table->setCurrentIndex(m_shown->index(row, kName));
            return;
        }
    m_table->clearSelection();
    m_table->setCurrentIndex({});
    choose(person);
}

PeoplePart::Typed PeoplePart::typed() const
{
    return {m_inForm, m_username->text(), m_given->text(), m_family->text(), m_role->currentIndex(), tickedClasses()};
}

/// Touched is not enough: what was typed and taken out again is nothing.
bool PeoplePart::isHalfFilled() const
{
    if (!m_isTouched)
        return false;
    const Typed now = typed();
    const Person* const person = find(m_inForm);
    if (person == nullptr)
        return !now.username.isEmpty() || !now.given.isEmpty() || !now.family.isEmpty();
    QSet<qint64> belongs;
    for (const database::ClassId one : person->classes)
        belongs.insert(one.value);
    return now.given != QString::fromStdString(person->givenName) ||
           now.family != QString::fromStdString(person->familyName) ||
           kRoles.at(static_cast<std::size_t>(std::max(0, now.role))) != person->role || now.classes != belongs;
}

void PeoplePart::putAside()
{
    if (!isHalfFilled())
        return;
    dropAside(typed());
    m_aside << typed();
    tellAside();
}

/// Of somebody new there may be several, told apart by the name to log in with.
void PeoplePart::dropAside(const Typed& what)
{
    m_aside.removeIf([&what](const Typed& one) {
        return one.person == what.person &&
               (one.person != 0 || (!one.username.isEmpty() && one.username == what.username));
    });
    tellAside();
}

QString PeoplePart::asideWords(qint64 person) const
{
    const Person* const whose = find(person);
    if (whose == nullptr)
        return tr("What you had typed for a new person is put aside.");
    //: %1 is a person
    return tr("What you had changed of %1 is put aside.")
        .arg(QString::fromStdString(whose->fullName().empty() ? whose->username : whose->fullName()));
}

void PeoplePart::tellAside()
{
    m_asideRow->setVisible(!m_aside.isEmpty());
    if (!m_aside.isEmpty())
        m_asideWords->setText(asideWords(m_aside.back().person));
}

void PeoplePart::bringBack()
{
    const Typed back = m_aside.takeLast();
    putAside();  // what has been typed since, of the same person as well
    m_isTouched = false;
    select(back.person);
    showForm();
    if (back.person == 0)
        m_username->setText(back.username);
    m_given->setText(back.given);
    m_family->setText(back.family);
    m_role->setCurrentIndex(back.role);
    const QSignalBlocker quiet(m_classList);
    for (int k = 0; k < m_classList->count(); ++k) {
        QListWidgetItem* const item = m_classList->item(k);
        item->setCheckState(back.classes.contains(item->data(kId).toLongLong()) ? Qt::Checked : Qt::Unchecked);
    }
    m_isTouched = true;
    tellAside();
}

QString PeoplePart::unkept() const
{
    if (isHalfFilled())
        return m_inForm == 0 ? tr("What you have typed for a new person is not entered.")
                             //: %1 is a person
                             : tr("What you have changed of %1 is not saved.").arg(m_title->text());
    return m_aside.isEmpty() ? QString() : asideWords(m_aside.back().person);
}

/// The question is about what was on the screen when it was asked.
void PeoplePart::endThought()
{
    if (!m_thought->isAsked())
        return;
    m_thought->end();
    m_said->clear();
    showButtons(chosen());
}

/// Of a double click whose first has changed what the buttons are.
bool PeoplePart::isSecondClick() const
{
    return m_sinceSubmitted.isValid() &&
           m_sinceSubmitted.elapsed() < QGuiApplication::styleHints()->mouseDoubleClickInterval();
}

void PeoplePart::forgetCodes()
{
    m_codes.clear();
    fill();
    showForm();
}

bool PeoplePart::mayLeave()
{
    const QString warning =
        tr("The one-time codes that are shown here are kept nowhere else. Esc once more leaves School without them.");
    // Who has done anything else meanwhile does not remember it.
    if (m_codes.isEmpty() || m_said->text() == warning)
        return true;
    study::showFault(m_fault, {});
    m_said->setText(warning);
    return false;
}

void PeoplePart::showForm()
{
    const Person* const person = chosen();
    // What is being typed outlives news of what others have entered.
    m_isTouched = std::exchange(m_inForm, m_chosen) == m_chosen && m_isTouched;
    m_title->setText(person == nullptr
                         ? tr("New person")
                         : QString::fromStdString(person->fullName().empty() ? person->username : person->fullName()));
    m_username->setReadOnly(person != nullptr);
    if (person != nullptr && !m_isTouched) {
        m_username->setText(QString::fromStdString(person->username));
        m_given->setText(QString::fromStdString(person->givenName));
        m_family->setText(QString::fromStdString(person->familyName));
        m_role->setCurrentIndex(
            static_cast<int>(std::find(kRoles.begin(), kRoles.end(), person->role) - kRoles.begin()));
    }
    fillClasses(person);
    showButtons(person);
    const Code code = m_codes.value(m_chosen);
    m_codeCard->setVisible(!code.code.isEmpty());
    m_code->setText(code.code);
    m_codeWords->setText(tr("One-time code of %1. Tell it now: it is kept nowhere. It is shown here, whenever %1 is "
                            "chosen, until School is left.")
                             .arg(code.fullName));
    tellAside();
}

void PeoplePart::showButtons(const Person* person)
{
    m_save->setText(person == nullptr ? tr("Enter the person") : tr("Save the changes"));
    m_save->setAccessibleName(m_save->text());
    m_reset->setVisible(person != nullptr);
    const bool isAsked = m_thought->isAsked();
    const bool hasPassword = person != nullptr && person->hasPassword;
    m_reset->setText(!isAsked ? tr("Reset password") : hasPassword ? tr("Yes, take it away") : tr("Yes, make another"));
    m_reset->setAccessibleName(isAsked && hasPassword ? tr("Yes, take the password away") : m_reset->text());
    m_keepPassword->setVisible(isAsked);
    if (isAsked && person != nullptr)
        m_said->setText(person->hasPassword
                            //: %1 is a person
                            ? tr("%1 will need a new one-time code: take the password away?").arg(m_title->text())
                            //: %1 is a person
                            : tr("The one-time code of %1 above would let nobody in any longer: make another?")
                                  .arg(m_title->text()));
    m_disable->setVisible(person != nullptr && !isAsked);
    m_disable->setText(person != nullptr && person->disabled ? tr("Enable") : tr("Disable"));
    m_disable->setAccessibleName(m_disable->text());
    m_disable->setToolTip(brokenIntoLines(tr("Who is disabled cannot log in; attempts and names stay")));
}

/// The person's own first; DEN2 before DEN10.
void PeoplePart::fillClasses(const Person* person)
{
    const QSet<qint64> ticked = tickedClasses();
    const auto belongs = [&](const database::SchoolClass& one) {
        return person != nullptr && !m_isTouched
                   ? std::find(person->classes.begin(), person->classes.end(), one.id) != person->classes.end()
                   : ticked.contains(one.id.value) || one.name == m_classAdded;
    };
    QCollator byName;
    byName.setNumericMode(true);
    QList<database::SchoolClass> sorted = m_classes;
    std::sort(sorted.begin(), sorted.end(), [&](const database::SchoolClass& a, const database::SchoolClass& b) {
        if (belongs(a) != belongs(b))
            return belongs(a);
        return byName.compare(QString::fromStdString(a.name), QString::fromStdString(b.name)) < 0;
    });
    const QSignalBlocker quiet(m_classList);  // of what the program ticks
    m_classList->clear();
    for (const database::SchoolClass& one : sorted) {
        auto* item = new QListWidgetItem(QString::fromStdString(one.name), m_classList);
        item->setData(kId, QVariant::fromValue<qint64>(one.id.value));
        item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
        item->setSizeHint({0, kTickPx});
        item->setCheckState(belongs(one) ? Qt::Checked : Qt::Unchecked);
    }
    if (std::any_of(m_classes.begin(), m_classes.end(), [this](const auto& one) { return one.name == m_classAdded; }))
        m_classAdded.clear();
}

QSet<qint64> PeoplePart::tickedClasses() const
{
    QSet<qint64> ticked;
    for (int k = 0; k < m_classList->count(); ++k)
        if (m_classList->item(k)->checkState() == Qt::Checked)
            ticked.insert(m_classList->item(k)->data(kId).toLongLong());
    return ticked;
}

void PeoplePart::submit()
{
    if (isSecondClick())
        return;
    endThought();
    study::showFault(m_fault, {});
    m_said->clear();
    const Role role = kRoles.at(static_cast<std::size_t>(std::max(0, m_role->currentIndex())));
    const std::string given = m_given->text().trimmed().toStdString();
    const std::string family = m_family->text().trimmed().toStdString();
    if (const Person* const person = chosen()) {
        Person changed = *person;
        changed.givenName = given;
        changed.familyName = family;
        changed.role = role;
        m_submitted = typed();
        m_sinceSubmitted.start();
        emit changeWanted(changed, tickedClasses());
    } else if (const QString name = m_username->text().trimmed(); name.isEmpty()) {
        study::showFault(m_fault, tr("The name to log in with is missing."));
        m_username->setFocus();
    } else {
        m_submitted = typed();
        m_sinceSubmitted.start();
        emit addWanted({name.toStdString(), given, family, role}, tickedClasses());
    }
    QTimer::singleShot(kSoonMs, this, [this] {
        if (m_submitted)
            m_said->setText(tr("The school's data are being written to …"));
    });
}

/// A password is gone for good, and a code that is shown may have been told: one click must not do it.
void PeoplePart::askToReset()
{
    if (isSecondClick())
        return;
    const Person* const person = chosen();
    if (m_thought->isAsked() && !m_thought->mayBeAnswered())
        return;
    if (person != nullptr && (person->hasPassword || m_codes.contains(m_chosen)) && !m_thought->isAsked()) {
        m_thought->ask();
        showForm();
        m_keepPassword->setFocus();
        return;
    }
    m_thought->end();
    m_said->clear();
    showForm();
    emit resetWanted(m_chosen);
}

void PeoplePart::toggleDisabled()
{
    const Person* const person = chosen();
    if (person == nullptr || isSecondClick())
        return;
    Person changed = *person;
    changed.disabled = !changed.disabled;
    // A code is not to be told to who cannot use it.
    m_codes.remove(m_chosen);
    showForm();
    QSet<qint64> classes;
    for (const database::ClassId one : person->classes)
        classes.insert(one.value);
    emit changeWanted(changed, classes);
}

void PeoplePart::showCode(database::PersonId person, const QString& fullName, const QString& code)
{
    m_codes.insert(person.value, {fullName, code});
    fill();
    showForm();
    m_pane->ensureVisible(0, 0);
}

void PeoplePart::confirm(database::PersonId person, const QString& sentence)
{
    // What was not sent with this stays as it was typed, or is put aside.
    const std::optional<Typed> submitted = std::exchange(m_submitted, std::nullopt);
    if (submitted) {
        dropAside(*submitted);
        m_isTouched = m_isTouched && m_inForm != submitted->person;
    }
    if (m_inForm != person.value)
        putAside();
    if (submitted && submitted->person == 0)  // the buttons of somebody who is there come under the pointer
        m_sinceSubmitted.start();
    m_chosen = person.value;
    m_className->clear();
    study::showFault(m_fault, {});
    m_said->setText(sentence);
}

void PeoplePart::refuse(const QString& sentence)
{
    m_submitted.reset();
    m_said->clear();
    study::showFault(m_fault, sentence);
}

}  // namespace ui::admin
