// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/admin/PeoplePart.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <QClipboard>
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
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStyleHints>
#include <QTimer>
#include <QVBoxLayout>

#include "database/NameOrder.h"
#include "ui/admin/AdminWords.h"
#include "ui/admin/EraseQuestion.h"
#include "ui/admin/PeopleModel.h"
#include "ui/admin/TickList.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/InlineConfirmation.h"
#include "ui/kit/ListTable.h"
#include "ui/kit/ScrollPane.h"
#include "ui/kit/Theme.h"
#include "ui/kit/UnsavedChanges.h"
#include "ui/kit/WordFilter.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/PeopleTexts.h"

namespace ui::admin {
namespace {

using namespace ui::kit;
using database::Person;
using database::Role;

constexpr int kId = Qt::UserRole + 1;  ///< id of a class in the form's list
constexpr int kFormPx = 340;
constexpr int kTickPx = 28;
constexpr int kSoonMs = 100;  ///< longer operations show a message

QString nameOf(const Person& person)
{
    return QString::fromStdString(person.fullName().empty() ? person.username : person.fullName());
}

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
    text::bindTranslation(this, [this] { retranslateUi(); });
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
        text::bindTranslation(clear, [clear] { clear->setAccessibleName(tr("Clear the search")); });
    m_count = new QLabel(side);
    m_count->setObjectName(QStringLiteral("peopleCount"));
    m_count->setForegroundRole(QPalette::PlaceholderText);
    m_new = button("filled", "newPerson", side);
    head->addWidget(m_search, 1);
    head->addWidget(m_count);
    head->addWidget(m_new);
    column->addLayout(head);
    m_rows = new PeopleModel(side);
    m_shown = new kit::WordFilter(side);
    m_shown->setSourceModel(m_rows);
    m_shown->setSortRole(PeopleModel::SortBy);
    m_shown->setSortLocaleAware(true);
    m_table = new kit::ListTable(side);
    m_table->setObjectName(QStringLiteral("people"));
    m_table->setModel(m_shown);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->verticalHeader()->hide();
    QHeaderView* const heads = m_table->horizontalHeader();
    heads->setResizeContentsPrecision(0);  // measures visible rows only, so that thousands of rows cost no time
    for (int section = 0; section < PeopleModel::Columns; ++section)
        heads->setSectionResizeMode(section, QHeaderView::ResizeToContents);
    for (const PeopleModel::Column wide : {PeopleModel::Name, PeopleModel::Username, PeopleModel::Classes})
        heads->setSectionResizeMode(wide, QHeaderView::Stretch);
    m_table->sortByColumn(PeopleModel::Name, Qt::AscendingOrder);
    column->addWidget(m_table, 1);
    connect(m_search, &QLineEdit::textChanged, this, &PeoplePart::filter);
    connect(m_new, &QPushButton::clicked, this, [this] {
        select(0);
        if (!isHalfFilled())  // otherwise a question is asked
            m_username->setFocus();
    });
    // A row that becomes current when the table gets the focus was not chosen by the user.
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        if (const QModelIndexList rows = m_table->selectionModel()->selectedRows(PeopleModel::Name); !rows.isEmpty())
            choose(rows.front().data(PeopleModel::Id).toLongLong());
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
    m_title = kit::formWords({}, kTitle, QFont::DemiBold, QPalette::WindowText, form);
    m_title->setTextFormat(Qt::PlainText);
    column->addWidget(m_title);
    column->addWidget(makeCodeCard(form));
    addFields(column, form);
    addClassFields(column, form);
    auto* whole = new QWidget(this);
    whole->setFixedWidth(kFormPx);
    auto* stack = new QVBoxLayout(whole);
    stack->setContentsMargins(0, 0, 0, 0);
    m_pane = new ScrollPane(form, QPalette::Window, whole);
    stack->addWidget(m_pane, 1);
    addButtons(stack, whole);
    connectForm();
    return whole;
}

/// Makes the card with the one-time code of the person in the form.
QWidget* PeoplePart::makeCodeCard(QWidget* form)
{
    m_codeCard = new QFrame(form);
    m_codeCard->setProperty("kind", "card");
    auto* code = new QVBoxLayout(m_codeCard);
    m_codeWords = kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, m_codeCard);
    m_codeWords->setTextFormat(Qt::PlainText);
    m_code = new QLabel(m_codeCard);
    m_code->setObjectName(QStringLiteral("oneTimeCode"));
    m_code->setFont(typeface(kTitle, QFont::DemiBold));
    m_code->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_copy = button("", "copyCode", m_codeCard);
    code->addWidget(m_codeWords);
    code->addWidget(m_code);
    code->addWidget(m_copy, 0, Qt::AlignLeft);
    return m_codeCard;
}

/// Adds the fields for names and role.
void PeoplePart::addFields(QVBoxLayout* column, QWidget* form)
{
    m_username = input("personUsername", form);
    m_given = input("personGiven", form);
    m_family = input("personFamily", form);
    m_role = kit::choiceInput({}, form);
    m_role->setObjectName(QStringLiteral("personRole"));
    m_role->setMinimumHeight(m_username->sizeHint().height());
    // Each field has a label above it that stays readable after the field has been filled in.
    const auto headed = [form, column](QWidget* field) {
        auto* word = kit::formWords({}, kSmall, QFont::Normal, QPalette::PlaceholderText, form);
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
}

/// Adds the list of classes, and the field for the name of a class to add or rename.
void PeoplePart::addClassFields(QVBoxLayout* column, QWidget* form)
{
    m_classesWord = kit::formWords({}, kSmall, QFont::Normal, QPalette::PlaceholderText, form);
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
}

/// Adds the buttons of the form and the messages beside them.
void PeoplePart::addButtons(QVBoxLayout* stack, QWidget* whole)
{
    // Messages are beside the buttons, outside the scrolled part, so that they are always visible.
    m_fault = kit::faultLabel(whole);
    m_fault->setObjectName(QStringLiteral("personFault"));
    m_said = kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, whole);
    m_said->setObjectName(QStringLiteral("personSaid"));
    m_said->setTextFormat(Qt::PlainText);
    stack->addWidget(m_fault);
    stack->addWidget(m_said);
    m_save = button("filled", "savePerson", whole);
    m_reset = button("", "resetPassword", whole);
    m_keep = button("", "keepAsItIs", whole);
    m_disable = button("", "disablePerson", whole);
    m_erase = button("quiet", "erasePerson", whole);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_reset);
    buttons->addWidget(m_keep);
    buttons->addWidget(m_disable);
    buttons->addStretch(1);
    auto* first = new QHBoxLayout;
    first->addWidget(m_save);
    first->addStretch(1);
    first->addWidget(m_erase);
    stack->addLayout(first);
    stack->addLayout(buttons);
}

void PeoplePart::connectForm()
{
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
    m_thought = new kit::InlineConfirmation(*this);
    connect(m_keep, &QPushButton::clicked, this, &PeoplePart::keepAsItIs);
    connect(m_thought, &kit::InlineConfirmation::withdrawn, this, &PeoplePart::keepAsItIs);
    connect(m_disable, &QPushButton::clicked, this, &PeoplePart::toggleDisabled);
    connect(m_erase, &QPushButton::clicked, this, &PeoplePart::askToErase);
    connect(m_copy, &QPushButton::clicked, this, [this] {
        QGuiApplication::clipboard()->setText(m_code->text());
        m_codes[m_chosen].isCopied = true;
    });
    connectClasses();
}

void PeoplePart::connectClasses()
{
    connect(m_addClass, &QPushButton::clicked, this, &PeoplePart::addClass);
    connect(m_className, &QLineEdit::returnPressed, this, &PeoplePart::addClass);
    connect(m_renameClass, &QPushButton::clicked, this, [this] {
        endThought();
        const QListWidgetItem* item = m_classList->currentItem();
        if (const QString name = m_className->text().trimmed(); item != nullptr && !name.isEmpty())
            emit classNameRequested(item->data(kId).toLongLong(), name);
    });
    const auto updateRename = [this] {
        m_renameClass->setEnabled(m_classList->currentItem() != nullptr && !m_className->text().trimmed().isEmpty());
        m_addClass->setEnabled(!m_className->text().trimmed().isEmpty());
    };
    connect(m_className, &QLineEdit::textChanged, this, updateRename);
    connect(m_classList, &QListWidget::currentRowChanged, this, updateRename);
    updateRename();
}

/// Ticks the class whose name was typed, or requests a new class of that name.
void PeoplePart::addClass()
{
    endThought();
    const QString wanted = m_className->text().trimmed();
    for (int k = 0; k < m_classList->count(); ++k)
        if (QListWidgetItem* const there = m_classList->item(k); there->text() == wanted) {
            there->setCheckState(Qt::Checked);
            m_classList->scrollToItem(there);
            m_className->clear();
            //: %1: the name of a class
            say([wanted] { return tr("There is a class %1 already. It is ticked above.").arg(wanted); });
            return;
        }
    if (wanted.isEmpty() || wanted.toStdString() == m_classAdded)  // has been requested already
        return;
    m_classAdded = wanted.toStdString();
    emit classRequested(wanted);
}

/// Cancels the question that the form asks. The person stays as they are.
void PeoplePart::keepAsItIs()
{
    m_thought->end();
    say({});
    if (const Person* const person = chosen(); person != nullptr && m_question == Question::OwnRole)
        m_role->setCurrentIndex(TypedPerson::asEntered(*person).role);
    showForm();
    (m_question == Question::Password ? m_reset : m_question == Question::OwnRole ? m_save : m_disable)->setFocus();
}

void PeoplePart::retranslateUi()
{
    const auto name = [](QLineEdit* one, const QString& words) {
        one->setPlaceholderText(words);
        one->setToolTip(words);
        one->setAccessibleName(words);
    };
    name(m_search, tr("Search: a name, a class, a role"));
    for (const auto& [field, word, words] :
         {std::tuple(m_username, m_usernameWord, tr("Username")), std::tuple(m_given, m_givenWord, tr("Given name")),
          std::tuple(m_family, m_familyWord, tr("Family name"))}) {
        field->setAccessibleName(words);
        word->setText(words);
    }
    m_roleWord->setText(tr("Role"));
    name(m_className, tr("Name of a class"));
    m_table->setAccessibleName(tr("People"));
    m_rows->setHeads({tr("Name"), tr("Login"), tr("Role"), tr("Classes"), tr("Last login"), tr("State")});
    // No column is narrower than its heading. If there is too little room, the list scrolls sideways.
    int widest = 0;
    for (const PeopleModel::Column one : {PeopleModel::Name, PeopleModel::Username, PeopleModel::Classes})
        widest = std::max(widest, m_table->horizontalHeader()->sectionSizeHint(one));
    m_table->horizontalHeader()->setMinimumSectionSize(widest);
    m_new->setText(tr("New person"));
    m_classesWord->setText(tr("Classes"));
    m_classList->setAccessibleName(tr("Classes"));
    m_addClass->setText(tr("Add"));
    m_addClass->setToolTip(tr("Add a class of this name"));
    m_renameClass->setText(tr("Rename"));
    m_renameClass->setToolTip(tr("Give this name to the class that is chosen above"));
    m_reset->setToolTip(brokenIntoLines(tr("Take the password away and give a one-time code in its place")));
    m_erase->setText(tr("Erase …"));
    m_erase->setAccessibleName(tr("Erase the person"));
    m_erase->setToolTip(brokenIntoLines(tr("Remove names, login and comments; the attempts stay under a pseudonym")));
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
    kit::nameInput(m_role, tr("Role"));
    say(m_sentence, m_faultSentence);
    fill();
    showForm();
}

QString PeoplePart::stateOf(const Person& person, const std::string& nowUtc) const
{
    if (person.isErased())
        return tr("erased");
    if (person.disabled)
        return tr("disabled");
    if (person.hasPassword)
        return tr("can log in");
    if (m_codes.contains(person.id.value))
        return tr("has a one-time code, shown here");
    return person.codeUntilUtc >= nowUtc ? tr("has a one-time code") : tr("needs a one-time code");
}

void PeoplePart::fill()
{
    const QSignalBlocker quiet(m_table->selectionModel());
    // Keeps the scroll position. Scrolls the selected person into view only if their row was visible before.
    const int scrolled = m_table->verticalScrollBar()->value();
    const QModelIndex before = rowOf(m_chosen);
    const bool wasSeen = !before.isValid() || m_table->viewport()->rect().intersects(m_table->visualRect(before));
    const std::string now = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    QList<PeopleModel::Row> rows;
    rows.reserve(m_people.size());
    for (const Person& person : m_people) {
        QStringList classes;
        for (const database::SchoolClass& one : m_classes)
            if (std::find(person.classes.begin(), person.classes.end(), one.id) != person.classes.end())
                classes << QString::fromStdString(one.name);
        rows << PeopleModel::Row{person.id.value,
                                 {QString::fromStdString(person.fullName()), QString::fromStdString(person.username),
                                  roleWord(person.role), classes.join(QStringLiteral(", ")),
                                  text::when(person.lastLoginUtc), stateOf(person, now)},
                                 QString::fromStdString(person.familyName),
                                 QString::fromStdString(person.lastLoginUtc)};
    }
    m_rows->setRows(rows);
    showFound();
    m_table->doItemsLayout();
    m_table->verticalScrollBar()->setValue(scrolled);
    if (const QModelIndex chosen = rowOf(m_chosen); wasSeen && chosen.isValid())
        m_table->scrollTo(chosen);
}

/// Returns the row of a person in the filtered list. The index is invalid if they are not shown.
QModelIndex PeoplePart::rowOf(qint64 person) const
{
    for (int row = 0; row < m_shown->rowCount() && person != 0; ++row)
        if (const QModelIndex index = m_shown->index(row, PeopleModel::Name);
            index.data(PeopleModel::Id).toLongLong() == person)
            return index;
    return {};
}

void PeoplePart::filter()
{
    showFound();
    m_table->doItemsLayout();  // scrollTo() needs the new layout
    if (const QModelIndex chosen = rowOf(m_chosen); chosen.isValid())
        m_table->scrollTo(chosen);
}

void PeoplePart::showFound()
{
    // Keeps the selection on the person whose form is open. When the search hides their row, the table would select a
    // neighbouring row. Selects their row again when it becomes visible.
    const QSignalBlocker quiet(m_table->selectionModel());
    m_shown->setWords(m_search->text());
    m_count->setText(tr("%Ln person(s)", nullptr, m_shown->rowCount()));
    m_table->clearSelection();
    if (const QModelIndex chosen = rowOf(m_chosen); chosen.isValid())
        m_table->selectRow(chosen.row());
    m_table->viewport()->update();
}

void PeoplePart::setPeople(const QList<Person>& people, const QList<database::SchoolClass>& classes)
{
    m_people = people;
    m_classes = classes;
    // Forgets codes that have been used or replaced.
    m_codes.removeIf([this](const std::pair<const qint64&, Code&>& one) {
        const Person* const whose = find(one.first);
        return whose == nullptr || whose->hasPassword || whose->codeUntilUtc != one.second.untilUtc;
    });
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
    if (isHalfFilled()) {
        showFound();  // selects the row of the form's person again
        UnsavedChanges::ask(window(), formWords(), [this, person] {
            m_isTouched = false;
            select(person);
        });
        return;
    }
    m_chosen = person;
    m_isTouched = false;
    m_classAdded.clear();
    m_sinceSubmitted.invalidate();
    m_thought->end();
    say({});
    if (person == 0) {
        for (QLineEdit* one : {m_username, m_given, m_family})
            one->clear();
        // The role is reset, so that nobody becomes an admin because an admin was viewed before.
        m_role->setCurrentIndex(0);
        m_classList->clear();
    }
    showForm();
}

void PeoplePart::select(qint64 person)
{
    if (const QModelIndex row = rowOf(person); row.isValid()) {
        m_table->setCurrentIndex(row);
        return;
    }
    m_table->clearSelection();
    m_table->setCurrentIndex({});
    choose(person);
}

/// Fills the form with the person as they are in the database now. Keeps the user's changes.
void PeoplePart::rebase(const Person& now, const TypedPerson& typed)
{
    const TypedPerson before = TypedPerson::asEntered(typed.asItWas);
    const TypedPerson entered = TypedPerson::asEntered(now);
    write(typed.onto(now));
    if (entered.given != before.given || entered.family != before.family || entered.role != before.role)
        say({}, [name = nameOf(now)] {
            //: %1 is a person
            return tr("Somebody else has changed %1 meanwhile. What you have typed stays here.").arg(name);
        });
}

TypedPerson PeoplePart::typed() const
{
    return {m_inForm, m_username->text(), m_given->text(), m_family->text(), m_role->currentIndex(), tickedClasses()};
}

void PeoplePart::write(const TypedPerson& typed)
{
    m_inForm = typed.asItWas;
    const auto put = [](QLineEdit* field, const QString& words) {
        if (field->text() != words)  // setText() would move the cursor while the user types
            field->setText(words);
    };
    put(m_username, typed.username);
    put(m_given, typed.given);
    put(m_family, typed.family);
    m_role->setCurrentIndex(typed.role);
    fillClasses(typed.classes);
}

/// Returns whether the form has unsaved input. Text that was typed and deleted again does not count.
bool PeoplePart::isHalfFilled() const
{
    if (!m_isTouched)
        return false;
    const TypedPerson now = typed();
    if (now.person() == 0)
        return !now.username.isEmpty() || !now.given.isEmpty() || !now.family.isEmpty();
    const TypedPerson before = TypedPerson::asEntered(m_inForm);
    return now.given != before.given || now.family != before.family || now.role != before.role ||
           now.classes != before.classes;
}

QString PeoplePart::formWords() const
{
    if (!isHalfFilled())
        return {};
    return m_inForm.id.value == 0 ? tr("What you have typed for a new person is not entered.")
                                  //: %1 is a person
                                  : tr("What you have changed of %1 is not saved.").arg(m_title->text());
}

QString PeoplePart::unsavedChanges() const
{
    QStringList sentences;
    if (isHalfFilled())
        sentences << formWords();
    QStringList names;
    for (const Code& one : m_codes)
        if (!one.isCopied)
            names << one.fullName;
    if (!names.isEmpty()) {
        std::sort(names.begin(), names.end(), database::NameOrder());
        //: %1: a person, or several
        sentences << tr("%n one-time code(s) are shown under School, and kept nowhere else: %1.", nullptr,
                        static_cast<int>(names.size()))
                         .arg(names.join(QStringLiteral(", ")));
    }
    return sentences.join(u'\n');
}

void PeoplePart::discardChanges()
{
    m_isTouched = false;
    m_submitted.reset();
    m_codes.clear();
    m_search->clear();
    m_className->clear();
    select(0);
    fill();
}

/// Cancels an open question, because it was about the earlier content of the form.
void PeoplePart::endThought()
{
    if (!m_thought->isAsked())
        return;
    m_thought->end();
    say({});
    showButtons(chosen());
}

/// Returns whether the user has confirmed an irreversible action. The first call asks for confirmation.
bool PeoplePart::isAnswered(Question question)
{
    if (m_thought->isAsked() && m_question == question) {
        if (!m_thought->mayBeAnswered())
            return false;
        endThought();
        return true;
    }
    m_question = question;
    m_thought->ask();
    showForm();
    m_keep->setFocus();
    return false;
}

/// Shows a message and an error. Both are shown again when the language changes.
void PeoplePart::say(const Words& sentence, const Words& fault)
{
    m_sentence = sentence;
    m_faultSentence = fault;
    m_said->setText(sentence ? sentence() : QString());
    kit::showFault(m_fault, fault ? fault() : QString());
}

bool PeoplePart::isOwn(const Person* person) const
{
    return person != nullptr && person->uid == m_admin.toStdString();
}

/// Returns whether a click is the second half of a double click whose first half changed the buttons.
bool PeoplePart::isSecondClick() const
{
    return m_sinceSubmitted.isValid() &&
           m_sinceSubmitted.elapsed() < QGuiApplication::styleHints()->mouseDoubleClickInterval();
}

void PeoplePart::showForm()
{
    const Person* const person = chosen();
    // The user's input is kept when changes of other users arrive.
    m_isTouched = m_inForm.id.value == m_chosen && m_isTouched;
    m_title->setText(person == nullptr ? tr("New person") : nameOf(*person));
    m_username->setReadOnly(person != nullptr);
    if (person != nullptr) {
        if (m_isTouched)
            rebase(*person, typed());
        else
            write(TypedPerson::asEntered(*person));
    } else {
        m_inForm = {};
        m_inForm.id = {m_chosen};  // the new person is not in the list yet
        fillClasses(tickedClasses());
    }
    showButtons(person);
    for (QWidget* field :
         {static_cast<QWidget*>(m_given), static_cast<QWidget*>(m_family), static_cast<QWidget*>(m_role),
          static_cast<QWidget*>(m_classList), static_cast<QWidget*>(m_className)})
        field->setEnabled(person == nullptr || !person->isErased());
    const Code code = m_codes.value(m_chosen);
    m_codeCard->setVisible(!code.code.isEmpty());
    m_code->setText(code.code);
    m_codeWords->setText(tr("One-time code of %1. Tell it now: it is kept nowhere. It is shown here, whenever %1 is "
                            "chosen, until you log out.")
                             .arg(code.fullName));
}

void PeoplePart::showButtons(const Person* person)
{
    const auto asks = [this](Question question) { return m_thought->isAsked() && m_question == question; };
    const bool isAsked = m_thought->isAsked();
    const bool ofPassword = asks(Question::Password);
    // The button above does not move when they appear. An answer takes the whole row.
    QSizePolicy keepsPlace = m_reset->sizePolicy();
    keepsPlace.setRetainSizeWhenHidden(!isAsked);
    m_reset->setSizePolicy(keepsPlace);
    m_save->setText(person == nullptr         ? tr("Enter the person")
                    : asks(Question::OwnRole) ? tr("Yes, save it")
                                              : tr("Save the changes"));
    m_save->setAccessibleName(m_save->text());
    m_reset->setVisible(person != nullptr && (!isAsked || ofPassword));
    const bool hasPassword = person != nullptr && person->hasPassword;
    m_reset->setText(!ofPassword   ? tr("Reset password")
                     : hasPassword ? tr("Yes, take it away")
                                   : tr("Yes, make another"));
    m_reset->setAccessibleName(ofPassword && hasPassword ? tr("Yes, take the password away") : m_reset->text());
    m_keep->setVisible(isAsked);
    m_keep->setText(asks(Question::OwnRole) ? tr("Stay an admin") : tr("Keep it"));
    m_keep->setAccessibleName(ofPassword ? tr("Keep the password") : m_keep->text());
    if (ofPassword && person != nullptr)
        m_said->setText(person->hasPassword
                            //: %1 is a person
                            ? tr("%1 will need a new one-time code: take the password away?").arg(m_title->text())
                            //: %1 is a person
                            : tr("The one-time code of %1 above would let nobody in any longer: make another?")
                                  .arg(m_title->text()));
    else if (asks(Question::OwnRole))
        m_said->setText(tr("You would be an admin no longer, and be logged out: save it all the same?"));
    else if (asks(Question::OwnAccount))
        m_said->setText(tr("This is your own account. You would be logged out, and could not log in again: disable "
                           "it?"));
    m_disable->setVisible(person != nullptr && (!isAsked || asks(Question::OwnAccount)));
    m_disable->setText(asks(Question::OwnAccount)              ? tr("Yes, disable it")
                       : person != nullptr && person->disabled ? tr("Enable")
                                                               : tr("Disable"));
    m_disable->setAccessibleName(m_disable->text());
    const bool isErased = person != nullptr && person->isErased();
    m_erase->setVisible(person != nullptr && !isAsked && !isErased && !isOwn(person));
    m_save->setVisible(!isErased);
    if (isErased) {
        m_reset->hide();
        m_disable->hide();
        if (!m_sentence)
            m_said->setText(tr("This person was erased. The attempts stay under this name."));
    }
    m_disable->setToolTip(brokenIntoLines(tr("Who is disabled cannot log in; attempts and names stay")));
}

/// Fills the list of classes: first the classes of the person, then the others. DEN2 comes before DEN10.
void PeoplePart::fillClasses(const QSet<qint64>& wanted)
{
    const auto belongs = [&](const database::SchoolClass& one) {
        return wanted.contains(one.id.value) || (m_isTouched && one.name == m_classAdded);
    };
    const database::NameOrder byName;
    QList<database::SchoolClass> sorted = m_classes;
    std::sort(sorted.begin(), sorted.end(), [&](const database::SchoolClass& a, const database::SchoolClass& b) {
        if (belongs(a) != belongs(b))
            return belongs(a);
        return byName(a.name, b.name);
    });
    const QSignalBlocker quiet(m_classList);  // ignores ticks set by the program
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
    const Person* const person = chosen();
    if (isSecondClick() || (person != nullptr && person->isErased()))
        return;
    const Role role = kRoles.at(static_cast<std::size_t>(std::max(0, m_role->currentIndex())));
    const bool givesUpRole = person != nullptr && isOwn(person) && person->role == Role::Admin && role != Role::Admin;
    if (givesUpRole && !isAnswered(Question::OwnRole))
        return;
    endThought();
    say({});
    const std::string given = m_given->text().trimmed().toStdString();
    const std::string family = m_family->text().trimmed().toStdString();
    if (person != nullptr) {
        Person changed = *person;
        changed.givenName = given;
        changed.familyName = family;
        changed.role = role;
        m_submitted = typed();
        m_sinceSubmitted.start();
        emit changeRequested(changed, tickedClasses());
    } else if (const QString name = m_username->text().trimmed(); name.isEmpty()) {
        say({}, [] { return tr("The username is missing."); });
        m_username->setFocus();
    } else {
        m_submitted = typed();
        m_sinceSubmitted.start();
        emit addRequested({name.toStdString(), given, family, role}, tickedClasses());
    }
    QTimer::singleShot(kSoonMs, this, [this] {
        if (m_submitted)
            say([] { return tr("The school's data are being written to …"); });
    });
}

/// Asks for confirmation before a password is reset. The old password would be lost, and a code on display may be in
/// use already.
void PeoplePart::askToReset()
{
    if (isSecondClick())
        return;
    const Person* const person = chosen();
    const bool isLoss = person != nullptr && (person->hasPassword || m_codes.contains(m_chosen));
    if (isLoss && !isAnswered(Question::Password))
        return;
    endThought();
    say({});
    emit resetRequested(m_chosen);
}

void PeoplePart::toggleDisabled()
{
    const Person* const person = chosen();
    if (person == nullptr || isSecondClick())
        return;
    if (isOwn(person) && !person->disabled && !isAnswered(Question::OwnAccount))
        return;
    Person changed = *person;
    changed.disabled = !changed.disabled;
    // A disabled user cannot use a code, so it is not shown.
    m_codes.remove(m_chosen);
    showForm();
    QSet<qint64> classes;
    for (const database::ClassId one : person->classes)
        classes.insert(one.value);
    emit changeRequested(changed, classes);
}

/// Asks before a person is erased, and requests it if the user confirms.
void PeoplePart::askToErase()
{
    const Person* const person = chosen();
    if (person == nullptr || isSecondClick())
        return;
    endThought();
    ui::admin::askToErase(window(), nameOf(*person), [this, id = m_chosen] {
        m_isTouched = false;  // what was typed is about a person who is erased
        m_codes.remove(id);
        say({});
        m_table->setFocus();  // the button is hidden for an erased person
        emit eraseRequested(id);
    });
}

void PeoplePart::showCode(const Person& person, const QString& code)
{
    m_codes.insert(person.id.value, {nameOf(person), code, person.codeUntilUtc});
    fill();
    showForm();
    m_pane->ensureVisible(0, 0);
}

void PeoplePart::confirm(database::PersonId person, const Words& sentence)
{
    const std::optional<TypedPerson> submitted = std::exchange(m_submitted, std::nullopt);
    if (submitted)
        m_isTouched = m_isTouched && m_inForm.id.value != submitted->person();
    if (submitted && submitted->person() == 0)  // the button for an existing person appears under the pointer
        m_sinceSubmitted.start();
    if (!isHalfFilled())  // otherwise the user is editing another person already
        m_chosen = person.value;
    m_className->clear();
    say(sentence);
}

void PeoplePart::refuse(const Words& sentence)
{
    m_submitted.reset();
    say({}, sentence);
}

void PeoplePart::confirmClass(const QString& name)
{
    // A class that the admin added while editing the form belongs to the person in the form.
    m_isTouched = m_isTouched || !m_classAdded.empty();
    if (m_className->text().trimmed() == name)  // unless the next name has been typed already
        m_className->clear();
    say({});
}

void PeoplePart::refuseClass(const Words& sentence)
{
    m_classAdded.clear();
    say({}, sentence);
}

}  // namespace ui::admin
