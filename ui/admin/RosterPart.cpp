// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/admin/RosterPart.h"

#include <algorithm>
#include <utility>

#include <QDragEnterEvent>
#include <QFileInfo>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMimeData>
#include <QPushButton>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "database/Codes.h"
#include "ui/admin/AdminWords.h"
#include "ui/kit/AppSettings.h"
#include "ui/kit/FileDialog.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/ListTable.h"
#include "ui/kit/StandardFolders.h"
#include "ui/kit/Theme.h"
#include "ui/kit/UnsavedChanges.h"
#include "ui/text/EveryLanguage.h"

namespace ui::admin {

using namespace ui::kit;

namespace {

constexpr auto* kExample = "username,given_name,family_name,role,class\n"
                           "s1001,Ada,Okafor,student,DEN101-A\n"
                           "s1002,Jürgen,Müller,student,DEN101-A|DEN102\n"
                           "teresa,Teresa,Rossi,instructor,DEN101-A";

const QString kFolder = QStringLiteral("folders/roster");

/// Returns the folder of the last class list read or the last codes saved.
QString folder()
{
    const QString last = memory().value(kFolder).toString();
    return QFileInfo(last).isDir() ? last : documentsFolder();
}

void remember(const QString& file)
{
    memory().setValue(kFolder, QFileInfo(file).absolutePath());
}

}  // namespace

RosterPart::RosterPart(QWidget* parent)
    : QWidget(parent), m_words(kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, this)),
      m_choose(new QPushButton(this)), m_enter(new QPushButton(this)), m_save(new QPushButton(this)),
      m_said(kit::formWords({}, kBody, QFont::Medium, QPalette::WindowText, this)), m_fault(kit::faultLabel(this)),
      m_example(new QLabel(this)), m_rows(new QStandardItemModel(this)), m_table(new kit::ListTable(this))
{
    setAcceptDrops(true);
    m_choose->setObjectName(QStringLiteral("chooseRoster"));
    m_enter->setObjectName(QStringLiteral("enterRoster"));
    m_enter->setProperty("kind", "filled");
    m_save->setObjectName(QStringLiteral("saveCodes"));
    m_said->setObjectName(QStringLiteral("rosterSaid"));
    m_said->setTextFormat(Qt::PlainText);
    m_table->setObjectName(QStringLiteral("roster"));
    m_table->setModel(m_rows);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSortingEnabled(false);  // keeps the order of the file
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace2);
    column->addWidget(m_words);
    auto* row = new QHBoxLayout;
    for (QPushButton* one : {m_choose, m_enter, m_save}) {
        one->setAutoDefault(false);
        row->addWidget(one);
    }
    row->addStretch(1);
    column->addLayout(row);
    column->addWidget(m_said);
    m_fault->setObjectName(QStringLiteral("rosterFault"));
    m_fault->setTextFormat(Qt::PlainText);
    column->addWidget(m_fault);
    m_example->setText(QString::fromUtf8(kExample));
    m_example->setObjectName(QStringLiteral("rosterExample"));
    m_example->setTextFormat(Qt::PlainText);
    m_example->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_example->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_example->setProperty("kind", "card");
    m_example->setContentsMargins(kSpace4, kSpace2, kSpace4, kSpace2);
    column->addWidget(m_example, 0, Qt::AlignLeft);
    column->addWidget(m_table, 100);
    column->addStretch(1);  // while there is no table
    connect(m_choose, &QPushButton::clicked, this, [this] { leaveCodes([this] { chooseFile(); }); });
    connect(m_enter, &QPushButton::clicked, this, [this] {
        m_isEntering = true;
        emit enterRequested();
    });
    connect(m_save, &QPushButton::clicked, this, &RosterPart::saveCodes);
    text::bindTranslation(this, [this] { retranslateUi(); });
}

void RosterPart::retranslateUi()
{
    m_words->setText(
        tr("A class list is a CSV file with the columns username, given_name, family_name, role and class. "
           "Role may be left out; several classes are parted by |. Choose it, or drop it here: nothing is "
           "entered before you have seen what it would do."));
    m_choose->setText(tr("Choose a file …"));
    m_enter->setText(tr("Enter these people"));
    m_save->setText(tr("Save the one-time codes …"));
    for (QPushButton* one : {m_choose, m_enter, m_save})
        one->setAccessibleName(one->text());
    m_table->setAccessibleName(tr("What the class list would do"));
    m_example->setAccessibleName(tr("Example of a class list"));
    fill();
    tell();
}

void RosterPart::tell()
{
    const int fresh = newcomers();
    m_enter->setVisible(!m_isDone && m_outcome.faults.empty() && !m_outcome.people.empty());
    m_save->setVisible(m_isDone && fresh > 0);
    m_table->setVisible(m_rows->rowCount() > 0);
    m_example->setVisible(m_file.isEmpty());
    const bool isAnybody = !m_outcome.people.empty();
    const bool isWrong = m_what.isEmpty() ? !m_file.isEmpty() && !isAnybody : m_isWrong;
    const QString words = m_what.isEmpty() ? outcomeWords() : m_what;
    kit::showFault(m_fault, isWrong ? words : QString());
    m_said->setText(isWrong ? QString() : words);
    m_said->setVisible(!isWrong);
}

QString RosterPart::outcomeWords() const
{
    if (m_file.isEmpty())
        return {};
    const QLocale locale;
    const int fresh = newcomers();
    const auto known = static_cast<int>(m_outcome.people.size()) - fresh;
    if (!m_outcome.faults.empty())
        return tr("%1: %Ln fault(s). Nothing was entered; mend the file and choose it again.", nullptr,
                  static_cast<int>(m_outcome.faults.size()))
            .arg(m_file);
    if (m_outcome.people.empty())
        return tr("There is nobody in %1: it has only the line that names the columns.").arg(m_file);
    if (m_isDone && fresh == 0)
        return tr("%1 was entered: nobody in it is new.").arg(m_file);
    if (m_isDone)
        return tr("%1 was entered: %2 new, %3 known already. The codes below are kept nowhere else.")
            .arg(m_file, locale.toString(fresh), locale.toString(known));
    //: %1: what another sentence says of how many are known already
    return tr("%1 %Ln new person(s) would be entered.", nullptr, fresh)
        .arg(tr("%1: %Ln person(s) known already.", nullptr, known).arg(m_file));
}

QString RosterPart::unsavedChanges() const
{
    if (m_isEntering)  // the codes have not arrived yet
        return tr("These people are being entered …");
    return !m_isDone || m_isSaved || newcomers() == 0
               ? QString()
               : tr("The one-time codes of %1 are not saved, and they are kept nowhere else.").arg(m_file);
}

int RosterPart::newcomers() const
{
    return static_cast<int>(std::count_if(m_outcome.people.begin(), m_outcome.people.end(),
                                          [](const database::RosterPerson& person) { return person.isNew; }));
}

void RosterPart::fill()
{
    m_rows->clear();
    const auto add = [this](const QStringList& words) {
        QList<QStandardItem*> row;
        for (const QString& one : words)
            row << new QStandardItem(one);
        m_rows->appendRow(row);
    };
    if (!m_outcome.faults.empty()) {
        m_rows->setHorizontalHeaderLabels({tr("Line"), tr("Column"), tr("What is wrong")});
        for (const database::RosterFault& fault : m_outcome.faults)
            add({QString::number(fault.line), QString::fromStdString(fault.column), rosterFaultWords(fault)});
    } else {
        // Shows what the import would do. After the import, shows the one-time codes.
        QStringList heads{tr("Login"), tr("Name"), tr("Role"), tr("Classes"), tr("State")};
        if (m_isDone)
            heads << tr("One-time code");
        m_rows->setHorizontalHeaderLabels(heads);
        const auto named = [this](const std::string& name) {
            const bool isNew = !m_isDone && std::find(m_outcome.newClasses.begin(), m_outcome.newClasses.end(), name) !=
                                                m_outcome.newClasses.end();
            //: %1: a class that would be added
            return isNew ? tr("%1 (new)").arg(QString::fromStdString(name)) : QString::fromStdString(name);
        };
        const auto state = [](const database::RosterPerson& person) {
            const QString known = person.isNew ? tr("new")
                                  : person.nameBefore.empty()
                                      ? tr("known")
                                      //: %1: the name that somebody on a class list had so far
                                      : tr("known as %1 so far").arg(QString::fromStdString(person.nameBefore));
            //: %1: "new" or "known", of somebody on a class list
            return person.isShort ? tr("%1; the line has fewer fields than the first").arg(known) : known;
        };
        for (const database::RosterPerson& person : m_outcome.people) {
            QStringList classes;
            for (const std::string& name : person.classes)
                classes << named(name);
            QStringList words{QString::fromStdString(person.username), QString::fromStdString(person.fullName),
                              roleWord(person.role), classes.join(QStringLiteral(", ")), state(person)};
            if (m_isDone)
                words << QString::fromStdString(person.code);
            add(words);
        }
    }
    m_table->resizeColumnsToContents();
}

void RosterPart::showOutcome(const database::RosterOutcome& outcome, const QString& file, bool isDone)
{
    m_outcome = outcome;
    m_file = QFileInfo(file).fileName();
    m_isEntering = false;
    m_isDone = isDone;
    m_isSaved = false;
    m_what.clear();
    m_fault->setToolTip({});
    fill();
    tell();
}

void RosterPart::say(const QString& sentence)
{
    m_what = sentence;
    m_isWrong = false;
    tell();
}

void RosterPart::refuse(const QString& sentence)
{
    m_what = sentence;
    m_isWrong = true;
    m_isEntering = false;
    tell();
}

void RosterPart::refuseFile(const QString& file, const QString& sentence, const QString& technical)
{
    showOutcome({}, file, false);
    refuse(sentence);
    m_fault->setToolTip(brokenIntoLines(technical));
}

/// Asks for confirmation before the user leaves unsaved codes, because each would have to be issued again.
void RosterPart::leaveCodes(const std::function<void()>& what)
{
    if (unsavedChanges().isEmpty())
        what();
    else
        UnsavedChanges::ask(window(), unsavedChanges(), what);
}

void RosterPart::chooseFile()
{
    auto* dialog = new FileDialog(this, tr("Choose a class list"), folder(), tr("Class lists (*.csv);;All files (*)"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &remember);
    connect(dialog, &QFileDialog::fileSelected, this, &RosterPart::fileChosen);
    dialog->open();
}

void RosterPart::saveCodes()
{
    auto* dialog = new FileDialog(this, tr("Save the one-time codes"), folder(), tr("Tables (*.csv)"));
    connect(dialog, &QFileDialog::fileSelected, this, &remember);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    connect(dialog, &QFileDialog::fileSelected, this, &RosterPart::writeCodes);
    dialog->open();
}

void RosterPart::writeCodes(const QString& path)
{
    m_isSaved = database::writeCodes(path, m_outcome.people).has_value();
    if (m_isSaved)
        say(tr("The codes were saved. Delete the file when everybody has logged in."));
    else
        refuse(tr("The codes could not be written. Choose another folder, or make room on the disk."));
}

void RosterPart::dragEnterEvent(QDragEnterEvent* event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls.front().isLocalFile())
        event->acceptProposedAction();
}

void RosterPart::dropEvent(QDropEvent* event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls.front().isLocalFile())
        leaveCodes([this, path = urls.front().toLocalFile()] { emit fileChosen(path); });
}

}  // namespace ui::admin
