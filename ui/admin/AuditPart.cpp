// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/admin/AuditPart.h"

#include <algorithm>

#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "ui/kit/FormInputs.h"
#include "ui/kit/ListTable.h"
#include "ui/kit/Theme.h"
#include "ui/kit/WordFilter.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/PeopleTexts.h"

namespace ui::admin {

using namespace ui::kit;

namespace {

enum Column { kNumber, kWhen, kWho, kAction, kObject, kDetail, kColumns };

constexpr int kObjectPx = 320;  ///< minimum width if the text needs it; longer text is elided

}  // namespace

AuditPart::AuditPart(QWidget* parent)
    : QWidget(parent), m_code(kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, this)),
      m_copy(new QPushButton(this)), m_search(new QLineEdit(this)), m_noAttempts(new QCheckBox(this)),
      m_count(new QLabel(this)), m_older(new QPushButton(this)), m_rows(new QStandardItemModel(0, kColumns, this)),
      m_shown(new kit::WordFilter(this)), m_table(new kit::ListTable(this))
{
    m_code->setObjectName(QStringLiteral("auditCode"));
    m_code->setTextFormat(Qt::PlainText);
    m_copy->setObjectName(QStringLiteral("copyAuditCode"));
    m_older->setObjectName(QStringLiteral("olderAudit"));
    m_search->setObjectName(QStringLiteral("auditSearch"));
    m_search->setClearButtonEnabled(true);
    for (auto* clear : m_search->findChildren<QAbstractButton*>())
        text::bindTranslation(clear, [clear] { clear->setAccessibleName(tr("Clear the search")); });
    m_search->setFont(typeface(kBody));
    m_noAttempts->setObjectName(QStringLiteral("auditNoAttempts"));
    m_count->setObjectName(QStringLiteral("auditCount"));
    m_count->setForegroundRole(QPalette::PlaceholderText);
    m_shown->setSourceModel(m_rows);
    m_table->setObjectName(QStringLiteral("audit"));
    m_table->setModel(m_shown);
    m_table->setSortingEnabled(false);  // keeps the order of the hash chain
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace2);
    auto* head = new QHBoxLayout;
    head->addWidget(m_code, 1);
    head->addWidget(m_copy);
    column->addLayout(head);
    auto* find = new QHBoxLayout;
    find->addWidget(m_search, 1);
    find->addWidget(m_noAttempts);
    find->addWidget(m_count);
    column->addLayout(find);
    column->addWidget(m_table, 1);
    column->addWidget(m_older, 0, Qt::AlignLeft);
    m_copy->setAutoDefault(false);
    m_older->setAutoDefault(false);
    connect(m_copy, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(m_head); });
    connect(m_search, &QLineEdit::textChanged, this, [this](const QString& words) {
        m_shown->setWords(words);
        tell();
    });
    // The rows on display stay until the answer arrives, but they do not match the filter any more.
    connect(m_noAttempts, &QCheckBox::toggled, this, [this] {
        m_isAsked = true;
        tell();
        emit newestRequested();
    });
    connect(m_older, &QPushButton::clicked, this, [this] {
        if (!m_audit.isEmpty())
            emit olderRequested(m_audit.back().seq);
    });
    text::bindTranslation(this, [this] { retranslateUi(); });
}

void AuditPart::retranslateUi()
{
    m_search->setPlaceholderText(tr("Search: a person, an action"));
    m_search->setAccessibleName(m_search->placeholderText());
    m_noAttempts->setText(tr("Leave out attempts"));
    m_noAttempts->setAccessibleName(m_noAttempts->text());
    m_noAttempts->setToolTip(brokenIntoLines(
        tr("Who began an exam or made an attempt is not shown: what is left is what was done to people, classes, "
           "grades, presets, settings and backups")));
    m_copy->setText(tr("Copy"));
    m_copy->setAccessibleName(tr("Copy the audit code"));
    m_older->setText(tr("Older rows"));
    m_older->setAccessibleName(m_older->text());
    m_table->setAccessibleName(tr("Audit"));
    fill();
    tell();
}

void AuditPart::tell()
{
    //: %1: a short code
    m_code->setText(tr("Audit code now: %1. Every report shows the code of its day. Type one beside \"Check "
                       "everything\" (Backups) to see whether what was noted before it is still as it was.")
                        .arg(m_head));
    m_code->setVisible(!m_head.isEmpty());  // hidden if the log could not be read
    m_count->setText(m_isAsked ? QString() : countWords());
    m_older->setEnabled(m_hasOlder && !m_isAsked);
}

QString AuditPart::countWords() const
{
    const int shown = m_shown->rowCount();
    if (m_search->text().isEmpty() || !m_hasOlder)
        return tr("%n row(s)", nullptr, shown);
    const QString searched = QLocale().toString(m_audit.size());
    if (leavesOutAttempts())
        //: %1: how many rows were searched
        return tr("%n row(s) among the newest %1 without attempts; \"Older rows\" brings more to search", nullptr,
                  shown)
            .arg(searched);
    //: %1: how many rows were searched
    return tr("%n row(s) among the newest %1; \"Older rows\" brings more to search", nullptr, shown).arg(searched);
}

bool AuditPart::leavesOutAttempts() const
{
    return m_noAttempts->isChecked();
}

void AuditPart::fill()
{
    m_rows->setRowCount(0);
    m_rows->setHorizontalHeaderLabels(
        {tr("No."), tr("When"), tr("Who"), tr("What"), tr("Whom or what"), tr("Details")});
    for (const database::AuditRow& row : m_audit) {
        QList<QStandardItem*> items;
        for (const QString& words :
             {QString::number(row.seq), text::when(row.atUtc), actorWords(row, m_names), actionWords(row.action),
              objectWords(row, m_names), detailWords(row, m_names, m_titles)})
            items << new QStandardItem(words);
        items[kObject]->setToolTip(brokenIntoLines(items[kObject]->text()));
        items.back()->setToolTip(brokenIntoLines(QString::fromStdString(row.detail)));
        m_rows->appendRow(items);
    }
    m_table->resizeColumnsToContents();
    fit();
}

/// Gives the column of objects, which may be long, the width that the other columns leave. It has a minimum.
void AuditPart::fit()
{
    const QAbstractItemView& cells = *m_table;
    int room = m_table->viewport()->width() - cells.sizeHintForColumn(kDetail);
    for (int column = 0; column < kDetail; ++column)
        room -= column == kObject ? 0 : m_table->columnWidth(column);
    const int wanted =
        std::max(cells.sizeHintForColumn(kObject), m_table->horizontalHeader()->sectionSizeHint(kObject));
    m_table->setColumnWidth(kObject, std::min(wanted, std::max(kObjectPx, room)));
}

void AuditPart::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fit();
}

void AuditPart::setNames(const NamesByUid& names)
{
    m_names = names;
    fill();
}

void AuditPart::setLessonTitles(const text::LessonTitles& titles)
{
    m_titles = titles;
    fill();
}

void AuditPart::setRows(const QList<database::AuditRow>& newestFirst, const QString& code, bool hasOlder)
{
    m_audit = newestFirst;
    m_head = code;
    m_hasOlder = hasOlder;
    m_isAsked = false;
    m_isWithoutAttempts = leavesOutAttempts();
    fill();
    tell();
}

void AuditPart::keepRows()
{
    const QSignalBlocker quiet(m_noAttempts);
    m_noAttempts->setChecked(m_isWithoutAttempts);
    m_isAsked = m_head.isEmpty();  // if no rows were ever read
    tell();
}

void AuditPart::addRows(qint64 beforeSeq, const QList<database::AuditRow>& newestFirst, bool hasOlder)
{
    if (m_audit.isEmpty() || m_audit.back().seq != beforeSeq)  // a second answer, or one for the other filter
        return;
    m_audit += newestFirst;
    m_hasOlder = hasOlder;
    fill();
    tell();
}

}  // namespace ui::admin
