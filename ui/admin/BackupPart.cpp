// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/admin/BackupPart.h"

#include <utility>

#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "ui/kit/FormInputs.h"
#include "ui/kit/InlineConfirmation.h"
#include "ui/kit/ListTable.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::admin {

using namespace ui::kit;

namespace {

constexpr int kLongestCode = 100;
constexpr int kFile = Qt::UserRole + 1;  ///< path of a row's backup

}  // namespace

BackupPart::BackupPart(QWidget* parent)
    : QWidget(parent), m_thought(new kit::InlineConfirmation(*this)),
      m_words(kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, this)), m_backUp(new QPushButton(this)),
      m_check(new QPushButton(this)), m_codeCaption(new QLabel(this)), m_code(new QLineEdit(this)),
      m_codeFault(kit::faultLabel(this)), m_restore(new QPushButton(this)), m_keep(new QPushButton(this)),
      m_stop(new QPushButton(this)), m_bar(new QProgressBar(this)),
      m_said(kit::formWords({}, kBody, QFont::Medium, QPalette::WindowText, this)),
      m_findings(new QPlainTextEdit(this)), m_rows(new QStandardItemModel(this)), m_table(new kit::ListTable(this))
{
    m_words->setTextFormat(Qt::PlainText);
    m_said->setTextFormat(Qt::PlainText);
    m_said->setObjectName(QStringLiteral("backupSaid"));
    m_backUp->setProperty("kind", "filled");
    m_backUp->setObjectName(QStringLiteral("backUp"));
    m_check->setObjectName(QStringLiteral("checkAll"));
    m_restore->setObjectName(QStringLiteral("restoreThis"));
    m_codeCaption->setFont(typeface(kBody));
    m_codeCaption->setBuddy(m_code);
    m_code->setObjectName(QStringLiteral("reportCode"));
    m_code->setFont(typeface(kBody));
    m_code->setMaxLength(kLongestCode);
    m_code->setMaximumWidth(2 * kit::kInputPx);
    m_codeFault->setObjectName(QStringLiteral("reportCodeFault"));
    m_stop->setObjectName(QStringLiteral("stopWork"));
    m_stop->setProperty("kind", "quiet");
    m_bar->setRange(0, 0);  // the duration is unknown
    m_bar->setTextVisible(false);
    m_findings->setReadOnly(true);
    m_findings->setObjectName(QStringLiteral("findings"));
    m_table->setObjectName(QStringLiteral("backups"));
    m_table->setModel(m_rows);
    m_table->setSortingEnabled(false);  // keeps newest first
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    arrange();
    connectButtons();
    m_findings->hide();
    text::bindTranslation(this, [this] { retranslateUi(); });
}

void BackupPart::arrange()
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace2);
    column->addWidget(m_words);
    auto* row = new QHBoxLayout;
    for (QPushButton* one : {m_backUp, m_check}) {
        one->setAutoDefault(false);
        row->addWidget(one);
    }
    row->addStretch(1);
    column->addLayout(row);
    auto* code = new QHBoxLayout;
    code->addWidget(m_codeCaption);
    code->addWidget(m_code);
    code->addWidget(m_codeFault, 1);
    code->addStretch();
    column->addLayout(code);
    auto* progress = new QHBoxLayout;
    progress->addWidget(m_bar, 1);
    progress->addWidget(m_stop);
    column->addLayout(progress);
    column->addWidget(m_said);
    column->addWidget(m_findings, 100);
    column->addWidget(m_table, 200);
    auto* last = new QHBoxLayout;
    m_keep->setObjectName(QStringLiteral("keepPresent"));
    m_keep->setAutoDefault(false);
    last->addWidget(m_restore);
    last->addWidget(m_keep);
    last->addStretch(1);
    column->addLayout(last);
    column->addStretch(1);  // a server has no table of backups
}

void BackupPart::connectButtons()
{
    const auto keep = [this] {
        m_thought->end();
        tell();
        m_restore->setFocus();
    };
    connect(m_keep, &QPushButton::clicked, this, keep);
    connect(m_thought, &kit::InlineConfirmation::withdrawn, this, keep);
    m_restore->setAutoDefault(false);
    m_stop->setAutoDefault(false);
    connect(m_backUp, &QPushButton::clicked, this, &BackupPart::backUpRequested);
    const auto check = [this] { emit checkRequested(m_code->text().trimmed()); };
    connect(m_check, &QPushButton::clicked, this, check);
    connect(m_code, &QLineEdit::returnPressed, this, check);
    connect(m_code, &QLineEdit::textChanged, this, [this] { kit::showFault(m_codeFault, {}); });
    connect(m_restore, &QPushButton::clicked, this, &BackupPart::restore);
    connect(m_stop, &QPushButton::clicked, this, &BackupPart::stopRequested);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        m_thought->end();
        tell();
    });
    connect(m_table, &QAbstractItemView::activated, this,
            [this](const QModelIndex& index) { m_table->selectRow(index.row()); });
}

void BackupPart::retranslateUi()
{
    m_backUp->setText(tr("Back up now"));
    m_check->setText(tr("Check everything"));
    m_check->setToolTip(brokenIntoLines(
        tr("Look at every page, every attempt and the whole audit for what was changed, removed or inserted")));
    m_codeCaption->setText(tr("Audit code of a report (optional):"));
    m_code->setAccessibleName(m_codeCaption->text());
    m_code->setToolTip(brokenIntoLines(tr(
        "\"Check everything\" then also looks whether the audit is still the one that the report was printed from")));
    kit::showFault(m_codeFault, {});
    m_stop->setText(tr("Stop"));
    m_keep->setText(tr("Keep what there is"));
    for (QPushButton* one : {m_backUp, m_check, m_stop, m_keep})
        one->setAccessibleName(one->text());
    m_bar->setAccessibleName(tr("Progress"));
    m_findings->setAccessibleName(tr("What the check found"));
    m_table->setAccessibleName(tr("Backups"));
    fill();
    tell();
}

void BackupPart::showResult()
{
    const QString said = m_sentence ? m_sentence() : QString();
    m_said->setText(m_isFault && !said.isEmpty() ? QStringLiteral("⚠ ") + said : said);
    QStringList lines;
    for (const database::IntegrityIssue& one : m_found)
        lines << findingWords(one, m_names, m_titles);
    if (const QString words = lines.join(u'\n'); m_findings->toPlainText() != words)
        m_findings->setPlainText(words);
    m_findings->setVisible(!lines.isEmpty());
}

void BackupPart::tell()
{
    m_words->setText(
        m_isServer
            ? tr("The school's data are on a server: %1. Its administrator makes the backups; \"cusp db copy\" brings "
                 "all of it into a file.")
                  .arg(m_where)
            : tr("The school's data are in %1. A backup is made every day the program is used. All of the last two "
                 "days are kept, then one for each of 12 days, 10 weeks and 9 months.")
                  .arg(m_where));
    for (QWidget* one :
         {static_cast<QWidget*>(m_backUp), static_cast<QWidget*>(m_table), static_cast<QWidget*>(m_restore)})
        one->setVisible(!m_isServer);
    for (QWidget* one : std::initializer_list<QWidget*>{m_backUp, m_check, m_code})
        one->setEnabled(!m_isBusy);
    m_bar->setVisible(m_isBusy);
    m_stop->setVisible(m_isBusy);
    m_restore->setEnabled(!m_isBusy && !chosen().isEmpty());
    const bool isAsked = m_thought->isAsked();
    m_restore->setText(isAsked ? tr("Yes: log everybody out and restore it") : tr("Restore the chosen backup …"));
    m_restore->setAccessibleName(m_restore->text());
    m_keep->setVisible(isAsked && !m_isServer);
    if (isAsked)
        m_said->setText(
            //: %1: when a backup was made
            tr("Restore the backup of %1? What was entered after it will be missing. Attempts of this computer that "
               "are in no backup are entered again. The present file is kept beside it.")
                .arg(chosenRow().data().toString()));
    else if (!m_isBusy)
        showResult();
}

void BackupPart::fill()
{
    const QString kept = chosen();
    m_rows->clear();
    m_rows->setHorizontalHeaderLabels({tr("Made"), tr("Size"), tr("File")});
    const QLocale locale;
    for (const Backup& one : m_backups) {
        auto* made = new QStandardItem(locale.toString(one.made.toLocalTime(), QLocale::ShortFormat));
        made->setData(one.file, kFile);
        m_rows->appendRow({made, new QStandardItem(locale.formattedDataSize(one.bytes)),
                           new QStandardItem(QFileInfo(one.file).fileName())});
        if (one.file == kept)
            m_table->selectRow(m_rows->rowCount() - 1);
    }
    m_table->resizeColumnsToContents();
    m_table->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
}

/// Returns the selected row. A row that only became current because the table got the focus does not count.
QModelIndex BackupPart::chosenRow() const
{
    return m_table->selectionModel()->selectedRows().value(0);
}

QString BackupPart::chosen() const
{
    return chosenRow().data(kFile).toString();
}

void BackupPart::setDatabase(const QString& where, bool isServer)
{
    m_where = where;
    m_isServer = isServer;
    tell();
}

void BackupPart::setBackups(const QList<Backup>& backups)
{
    // An open confirmation about a backup stays while the unchanged list is read again.
    if (backups == m_backups)
        return;
    m_backups = backups;
    fill();
    tell();
}

void BackupPart::showProgress(const QString& what)
{
    QWidget* const focused = window()->focusWidget();
    const bool begins = !std::exchange(m_isBusy, true);
    m_findings->hide();
    m_said->setText(what);
    tell();
    if (!begins)
        return;
    m_begunBy = isAncestorOf(focused) ? focused : nullptr;
    m_focusedMeanwhile = window()->focusWidget();
}

void BackupPart::setNames(const NamesByUid& names)
{
    m_names = names;
}

void BackupPart::setLessonTitles(const text::LessonTitles& titles)
{
    m_titles = titles;
    tell();
}

void BackupPart::finish(std::function<QString()> sentence, std::vector<database::IntegrityIssue> findings, bool isFault)
{
    m_isBusy = false;
    m_thought->end();
    m_sentence = std::move(sentence);
    m_isFault = isFault;
    m_found = std::move(findings);
    QWidget* const focused = window()->focusWidget();
    tell();
    // Disabling the button moved the focus to the next widget.
    if (m_begunBy != nullptr && focused == m_focusedMeanwhile)
        m_begunBy->setFocus();
    m_begunBy = nullptr;
}

void BackupPart::refuseCode()
{
    //: %1: an example
    kit::showFault(m_codeFault,
                   tr("This is no audit code. A report shows one such as %1.").arg(QStringLiteral("412-9f3ac07be1d2")));
    m_code->setFocus();
    m_code->selectAll();
}

/// Restores the selected backup after a confirmation, because every user is logged out. The present database is saved
/// beside the restored one.
void BackupPart::restore()
{
    if (!m_thought->isAsked()) {
        m_thought->ask();
        tell();
        m_keep->setFocus();
    } else if (m_thought->mayBeAnswered()) {
        m_thought->end();
        m_sentence = {};
        emit restoreRequested(chosen());
    }
}

}  // namespace ui::admin
