// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/MessageBar.h"

#include <algorithm>
#include <array>

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/kit/LineIcon.h"
#include "ui/kit/OffBur.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::kit {
namespace {

constexpr int kBarWidthPx = 720;
constexpr int kBarIconPx = 22;

MessageBar::Message inPresentLanguage(const MessageBar::Message& message)
{
    if (!message.again)
        return message;
    MessageBar::Message said = message.again();
    said.again = message.again;
    return said;
}

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), m_icon(new QLabel(this)), m_sentence(new QLabel(this)), m_detail(new QLabel(this)),
      m_button(new QPushButton(this)), m_decline(new QPushButton(this)), m_close(new QToolButton(this))
{
    for (QLabel* words : {m_sentence, m_detail})  // file names and lesson titles may look like rich text
        words->setTextFormat(Qt::PlainText);
    // Dark on every page, so that messages look the same everywhere.
    dress(*this, roomPalette());
    setProperty("kind", "card");
    setAutoFillBackground(true);
    text::bindTranslation(this, [this] { setAccessibleName(tr("Message")); });
    m_sentence->setWordWrap(true);
    m_sentence->setFont(typeface(kBody, QFont::Medium));
    m_detail->setWordWrap(true);
    m_detail->setFont(typeface(kSmall));
    m_detail->setForegroundRole(QPalette::PlaceholderText);
    m_detail->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_button->setFocusPolicy(Qt::TabFocus);
    m_decline->setFocusPolicy(Qt::TabFocus);
    m_decline->setObjectName(QStringLiteral("decline"));
    m_close->setFocusPolicy(Qt::TabFocus);
    m_close->setIcon(lineIcon(QStringLiteral("close"), palette()));
    text::bindTranslation(m_close, [this] {
        m_close->setToolTip(tr("Close this message (Esc)"));
        m_close->setAccessibleName(tr("Close this message"));
    });

    auto* words = new QVBoxLayout;
    words->setSpacing(kSpace1);
    words->addWidget(m_sentence);
    words->addWidget(m_detail);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kSpace4, kSpace2, kSpace2, kSpace2);
    row->setSpacing(kSpace4);
    row->addWidget(m_icon);
    row->addLayout(words, 1);
    row->addWidget(m_button);
    row->addWidget(m_decline);
    row->addWidget(m_close);

    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &MessageBar::dismiss);
    connect(m_close, &QToolButton::clicked, this, &MessageBar::dismiss);
    const auto doThenClose = [this](const std::function<void()>& what) {
        const auto action = what;
        dismiss();
        if (action)
            action();
    };
    connect(m_button, &QPushButton::clicked, this, [this, doThenClose] { doThenClose(m_now.action); });
    connect(m_decline, &QPushButton::clicked, this, [this, doThenClose] { doThenClose(m_now.declining.action); });
    text::bindTranslation(this, [this] {
        for (Message& message : m_waiting)
            message = inPresentLanguage(message);
        if (m_now.again)
            present(inPresentLanguage(m_now));
    });
    hide();
}

void MessageBar::say(const std::function<Message()>& words)
{
    Message message = words();
    message.again = words;
    say(message);
}

void MessageBar::say(const Message& message)
{
    if (stays() && message.sentence != m_now.sentence)
        m_waiting.push_front(m_now);
    present(message);
}

bool MessageBar::dismiss()
{
    if (!isVisibleTo(parentWidget()))
        return false;
    m_timer.stop();
    hide();
    m_now = {};
    if (!m_waiting.isEmpty())
        present(m_waiting.takeFirst());
    else
        emit changed();
    return true;
}

void MessageBar::withdraw(Topic topic)
{
    m_waiting.removeIf([topic](const Message& message) { return message.topic == topic; });
    if (m_now.topic == topic)
        dismiss();
}

QString MessageBar::sentence() const
{
    return isVisibleTo(parentWidget()) ? m_sentence->text() : QString();
}

void MessageBar::present(const Message& message)
{
    m_now = message;
    const Tones tone = tones(palette());
    struct Look
    {
        const char* drawing;
        QColor colour;
    };
    const std::array<Look, 3> looks{{{"info", tone.accent}, {"warning", tone.attention}, {"error", tone.harm}}};
    const Look& look = looks.at(static_cast<std::size_t>(message.kind));
    m_icon->setPixmap(linePixmap(QString::fromLatin1(look.drawing), look.colour, kBarIconPx, devicePixelRatioF()));
    m_sentence->setText(message.sentence);
    m_detail->setText(message.detail);
    m_detail->setVisible(!message.detail.isEmpty());
    m_button->setText(message.actionText);
    m_button->setAccessibleName(message.actionText);
    m_button->setVisible(!message.actionText.isEmpty());
    m_decline->setText(message.declining.text);
    m_decline->setAccessibleName(message.declining.text);
    m_decline->setVisible(!message.declining.text.isEmpty());
    m_sentence->setToolTip(brokenIntoLines(message.technical));
    m_detail->setToolTip(brokenIntoLines(message.technical));
    delete m_button->menu();
    if (!message.choices.isEmpty()) {
        auto* menu = new QMenu(m_button);
        for (const Choice& choice : message.choices)
            connect(menu->addAction(choice.text), &QAction::triggered, this, [this, action = choice.action] {
                dismiss();
                if (action)
                    action();
            });
        m_button->setMenu(menu);
    }
    setAccessibleDescription(message.sentence);
    QFrame::show();
    raise();
    placeIn(m_area, m_place);
    if (message.kind == Kind::News)
        m_timer.start(kNewsMs);
    else
        m_timer.stop();
    emit changed();
}

void MessageBar::placeIn(const QRect& area, Place place, const std::optional<QPointF>& bur)
{
    m_area = area;
    m_place = place;
    const int width = std::min(kBarWidthPx, area.width() - 2 * kSpace4);
    if (width <= 0)
        return;
    layout()->invalidate();
    for (QLayout* inner : layout()->findChildren<QLayout*>())
        inner->invalidate();  // otherwise the layout would return the height of the previous text
    const int height = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width) : sizeHint().height();
    if (place == Place::OverTheView) {
        const QRect atTop(area.center().x() - width / 2, area.top() + kSpace4, width, height);
        setGeometry(placeOffBur(bur, atTop, atTop.translated(0, area.bottom() - kSpace4 - atTop.bottom())).toRect());
    } else {
        setGeometry(area.right() - kSpace4 - width, area.top() + kSpace1, width, height);
    }
}

void MessageBar::enterEvent(QEnterEvent* event)
{
    m_timer.stop();
    QFrame::enterEvent(event);
}

void MessageBar::leaveEvent(QEvent* event)
{
    if (isVisible() && m_now.kind == Kind::News)
        m_timer.start(kNewsMs);
    QFrame::leaveEvent(event);
}

}  // namespace ui::kit
