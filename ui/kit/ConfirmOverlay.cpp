// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/ConfirmOverlay.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/kit/Accessibility.h"
#include "ui/kit/LineIcon.h"
#include "ui/kit/Theme.h"

namespace ui::kit {
namespace {

constexpr int kQuestionWidthPx = 520;
constexpr int kIconPx = 32;
constexpr QColor kVeil{0, 0, 0, 110};

}  // namespace

ConfirmOverlay::ConfirmOverlay(const Question& question, QWidget* parent)
    : QWidget(parent), m_card(new QFrame(this)), m_before(QApplication::focusWidget())
{
    m_card->setProperty("kind", "card");
    m_card->setAutoFillBackground(true);
    m_card->setAccessibleName(question.text);
    auto* icon = new QLabel(m_card);
    const QColor ink = question.discard ? tones(palette()).attention : palette().color(QPalette::Link);
    icon->setPixmap(linePixmap(question.drawing, ink, kIconPx, parent->devicePixelRatioF()));
    icon->setAlignment(Qt::AlignTop);
    const auto words = [this](const QString& said, int size, QFont::Weight weight, const char* name) {
        auto* label = new QLabel(said, m_card);
        label->setTextFormat(Qt::PlainText);
        label->setFont(typeface(size, weight));
        label->setWordWrap(true);
        label->setObjectName(QLatin1String(name));
        return label;
    };
    auto* text = new QVBoxLayout;
    text->setSpacing(kSpace2);
    text->addWidget(words(question.text, kTitle, QFont::DemiBold, "questionText"));
    text->addWidget(words(question.detail, kBody, QFont::Normal, "questionDetail"));
    auto* head = new QHBoxLayout;
    head->setSpacing(kSpace4);
    head->addWidget(icon, 0, Qt::AlignTop);
    head->addLayout(text, 1);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace2);
    row->addStretch(1);
    const auto offer = [&](const QString& said, const char* name, const char* kind, std::function<void()> doing) {
        auto* button = new QPushButton(said, m_card);
        button->setObjectName(QLatin1String(name));
        button->setProperty("kind", kind);
        button->setAutoDefault(true);
        button->setAccessibleName(QString(said).remove(u'&'));
        button->installEventFilter(this);
        connect(button, &QPushButton::clicked, this, [this, doing = std::move(doing)] { answer(doing); });
        row->addWidget(button);
        m_answers << button;
    };
    if (question.discard)
        offer(question.discardText.isEmpty() ? tr("&Discard") : question.discardText, "questionDiscard", "quiet",
              question.discard);
    const bool isLost = question.saveText.isEmpty();
    const QString stay = !isLost ? tr("&Cancel") : question.stayText.isEmpty() ? tr("&Stay") : question.stayText;
    offer(stay, "questionStay", isLost ? "filled" : "", [] {});
    if (!isLost)
        offer(question.saveText, "questionSave", "filled", question.save);
    auto* column = new QVBoxLayout(m_card);
    column->setContentsMargins(kSpace6, kSpace6, kSpace6, kSpace4);
    column->setSpacing(kSpace6);
    column->addLayout(head);
    column->addLayout(row);
    setGeometry(parent->rect());
    place();
    show();
    raise();
    m_answers.back()->setFocus();
    m_answers.back()->setAccessibleDescription(question.text + u' ' + question.detail);
    announce(*m_card);
    parent->installEventFilter(this);
}

void ConfirmOverlay::answer(const std::function<void()>& doing)
{
    hide();
    // A test, or a second question, must not find this one any more.
    setObjectName({});
    deleteLater();
    if (m_before && m_before->isVisible())
        m_before->setFocus();
    const auto todo = doing;
    todo();
}

/// Consumes all key events, so that none reaches the rest of the window.
bool ConfirmOverlay::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

bool ConfirmOverlay::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == parent()) {
        if (event->type() == QEvent::Resize)
            setGeometry(parentWidget()->rect());
        return false;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

bool ConfirmOverlay::focusNextPrevChild(bool next)
{
    const qsizetype at = m_answers.indexOf(qobject_cast<QPushButton*>(QApplication::focusWidget()));
    const qsizetype count = m_answers.size();
    m_answers[(at + (next ? 1 : count - 1)) % count]->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    return true;
}

void ConfirmOverlay::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape) {
        answer([] {});
        return;
    }
    if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right) {
        focusNextPrevChild(event->key() == Qt::Key_Right);
        return;
    }
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        m_answers.back()->click();
        return;
    }
    // The mnemonics of the answers work without Alt, too.
    for (QPushButton* button : std::as_const(m_answers)) {
        const qsizetype mark = button->text().indexOf(u'&');
        if (mark >= 0 && !event->text().isEmpty() &&
            button->text().mid(mark + 1, 1).compare(event->text(), Qt::CaseInsensitive) == 0) {
            button->click();
            return;
        }
    }
    event->accept();
}

void ConfirmOverlay::mousePressEvent(QMouseEvent* event)
{
    if (!m_card->geometry().contains(event->pos()))
        answer([] {});
}

void ConfirmOverlay::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), kVeil);
}

void ConfirmOverlay::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    place();
}

void ConfirmOverlay::place()
{
    const int across = std::min(kQuestionWidthPx, width() - 2 * kSpace4);
    m_card->setFixedWidth(across);
    m_card->resize(across, m_card->layout()->totalHeightForWidth(across));
    QRect at = m_card->rect();
    at.moveCenter(rect().center());
    m_card->move(at.topLeft());
}

}  // namespace ui::kit
