// SPDX-License-Identifier: GPL-3.0-or-later
// Buttons, sliders and keys. They change Playback and Stage, and show what those are.
import { icon, icons } from './icons';
import type { Playback } from './playback';
import { MostRate } from './playback';
import type { DrawStyle, Stage } from './stage';
import { language, setLanguage, text, type TextKey } from './texts';

const Turn = Math.PI / 24; // of a key
const Zoom = 1.15;
const Styles: DrawStyle[] = ['shaded', 'wireframe', 'points'];
const Keys: [string[], TextKey][] = [
    [['Space'], 'keySpace'], [['←', '→'], 'keyArrows'], [['Home', 'End'], 'keyEnds'],
    [['Shift ←', '→', '↑', '↓'], 'keyTurn'], [['+', '−'], 'keyZoom'], [['1', '2', '3'], 'keyStyle'],
    [['[', ']'], 'keyRate'], [['L'], 'keyLoop'], [['F'], 'keyFit'], [['Enter'], 'keyFull'], [['PgUp', 'PgDn'], 'keyList'],
];

export function element<E extends HTMLElement = HTMLElement>(id: string): E {
    return document.getElementById(id) as E;
}

/// What the controls ask of the page.
export interface Wishes {
    open(file: File): void;
    /// Goes on in the list.
    next(by: number): void;
    styleChanged(): void;
    languageChanged(): void;
}

export class Controls {
    private readonly frame = element<HTMLInputElement>('frame');
    private readonly rate = element<HTMLInputElement>('rate');
    private readonly rateSlider = element<HTMLInputElement>('rateslider');
    private readonly density = element<HTMLInputElement>('density');
    private readonly playButton = element('play');
    private style: DrawStyle = 'shaded';
    private shownPlaying: boolean | null = null;

    constructor(private readonly playback: Playback, private readonly stage: Stage, private readonly wishes: Wishes) {
        const faces: [string, keyof typeof icons][] = [
            ['first', 'firstFrame'], ['back', 'stepBack'], ['forward', 'stepForward'], ['last', 'lastFrame'], ['loop', 'loop'],
            ['shaded', 'shaded'], ['wireframe', 'wireframe'], ['points', 'points'], ['fit', 'fit'], ['full', 'fullScreen'], ['keys', 'keyboard'],
        ];
        for (const [id, face] of faces) element(id).innerHTML = icon(face);
        element('message').querySelector('button')!.innerHTML = icon('close');

        const actions: [string, () => void][] = [
            ['first', () => playback.step(-playback.frame)], ['back', () => playback.step(-1)], ['play', () => playback.toggle()],
            ['forward', () => playback.step(1)], ['last', () => playback.step(playback.frameCount)],
            ['loop', () => playback.setLoops(!playback.loops)], ['fit', () => stage.fit()], ['full', () => this.toggleFullScreen()],
            ['keys', () => element<HTMLDialogElement>('keyhelp').showModal()],
            ['open', () => element('file').click()],
            ['language', () => this.switchLanguage()],
        ];
        for (const [id, action] of actions) element(id).onclick = action;
        for (const style of Styles) element(style).onclick = () => this.setStyle(style);
        element('look').onkeydown = (event) => this.moveInRadioGroup(event);
        if (!document.fullscreenEnabled) element('full').hidden = true;

        this.frame.oninput = () => {
            const frame = this.frame.valueAsNumber; // pausing shows the old one
            playback.pause();
            playback.seek(frame);
        };
        this.rate.max = String(MostRate);
        this.rate.onchange = () => {
            playback.setRate(this.rate.valueAsNumber);
            this.showPlayback();
        };
        this.rateSlider.oninput = () => playback.setRate(this.rateSlider.valueAsNumber);
        this.density.oninput = () => stage.setDensity(this.density.valueAsNumber);
        element<HTMLInputElement>('file').onchange = (event) => {
            const input = event.target as HTMLInputElement;
            if (input.files?.[0]) wishes.open(input.files[0]);
            input.value = '';
        };
        document.addEventListener('keydown', (event) => this.key(event));
        playback.addEventListener('change', () => this.showPlayback());
        this.setStyle('shaded');
        this.showTexts();
    }

    showTexts(): void {
        document.documentElement.lang = language();
        document.querySelectorAll<HTMLElement>('[data-text]').forEach((part) => (part.textContent = text(part.dataset.text as TextKey)));
        document.querySelectorAll<HTMLElement>('[data-label]').forEach((part) => {
            part.setAttribute('aria-label', text(part.dataset.label as TextKey));
            if (part instanceof HTMLButtonElement) part.title = text(part.dataset.label as TextKey);
        });
        element('language').lang = language() === 'cs' ? 'en' : 'cs';
        element('keyhelp').querySelector('dl')!.replaceChildren(...Keys.flatMap(([keys, what]) => {
            const names = document.createElement('dt'), meaning = document.createElement('dd');
            for (const key of keys) {
                const cap = document.createElement('kbd');
                cap.textContent = key;
                names.append(cap, ' ');
            }
            meaning.textContent = text(what);
            return [names, meaning];
        }));
        this.shownPlaying = null;
        this.showPlayback();
    }

    setStyle(style: DrawStyle): void {
        this.style = style;
        this.stage.setStyle(style);
        for (const other of Styles) {
            element(other).setAttribute('aria-checked', String(other === style));
            element(other).tabIndex = other === style ? 0 : -1;
        }
        this.density.hidden = style !== 'points';
        this.wishes.styleChanged();
    }

    private showPlayback(): void {
        const { playback } = this;
        const last = String(playback.frameCount - 1);
        if (this.frame.max !== last) this.frame.max = last;
        this.frame.value = String(playback.frame);
        const place = `${playback.frame + 1} / ${playback.frameCount}`;
        this.frame.setAttribute('aria-valuetext', text('frameOf', playback.frame + 1, playback.frameCount));
        element('count').textContent = place;
        if (document.activeElement !== this.rate) this.rate.value = String(Math.round(playback.rate * 100) / 100);
        this.rateSlider.value = String(playback.rate);
        element('loop').setAttribute('aria-pressed', String(playback.loops));
        if (this.shownPlaying === playback.isPlaying) return;
        this.shownPlaying = playback.isPlaying;
        this.playButton.innerHTML = icon(playback.isPlaying ? 'pause' : 'play');
        const label = text(playback.isPlaying ? 'pause' : 'play');
        this.playButton.setAttribute('aria-label', label);
        this.playButton.title = label;
    }

    private key(event: KeyboardEvent): void {
        const target = event.target as HTMLElement;
        if (event.ctrlKey || event.metaKey || event.altKey || document.querySelector('dialog[open]')) return;
        if (target instanceof HTMLInputElement && target.type === 'number') return;
        const isSlider = target instanceof HTMLInputElement;
        const isButton = target instanceof HTMLButtonElement;
        // Keys that a control of the page needs itself.
        if (isSlider && /^(Arrow|Home|End|Page)/.test(event.key)) return;
        if (isButton && (event.key === 'Enter' || event.key === ' ')) return;
        if (target.closest('#look') && event.key.startsWith('Arrow')) return;
        const { playback, stage } = this;
        const turns: Record<string, [number, number]> = {
            ArrowLeft: [-Turn, 0], ArrowRight: [Turn, 0], ArrowUp: [0, -Turn], ArrowDown: [0, Turn],
        };
        const actions: Record<string, () => void> = {
            ' ': () => playback.toggle(), 'ArrowLeft': () => playback.step(-1), 'ArrowRight': () => playback.step(1),
            'Home': () => playback.step(-playback.frame), 'End': () => playback.step(playback.frameCount),
            '+': () => stage.move(0, 0, Zoom), '=': () => stage.move(0, 0, Zoom), '-': () => stage.move(0, 0, 1 / Zoom),
            '1': () => this.setStyle('shaded'), '2': () => this.setStyle('wireframe'), '3': () => this.setStyle('points'),
            '[': () => playback.setRate(playback.rate - 5), ']': () => playback.setRate(playback.rate + 5),
            'l': () => playback.setLoops(!playback.loops), 'f': () => stage.fit(), 'Enter': () => this.toggleFullScreen(),
            'PageUp': () => this.wishes.next(-1), 'PageDown': () => this.wishes.next(1),
        };
        const turn = event.shiftKey ? turns[event.key] : undefined;
        const action = turn ? () => stage.move(turn[0], turn[1], 1) : actions[event.key] ?? actions[event.key.toLowerCase()];
        if (!action) return;
        event.preventDefault();
        action();
    }

    private moveInRadioGroup(event: KeyboardEvent): void {
        const by = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 }[event.key];
        if (!by || !(event.target as HTMLElement).matches('[role=radio]')) return;
        event.preventDefault();
        this.setStyle(Styles[(Styles.indexOf(this.style) + by + Styles.length) % Styles.length]);
        element(this.style).focus();
    }

    private switchLanguage(): void {
        setLanguage(language() === 'cs' ? 'en' : 'cs');
        this.showTexts();
        this.wishes.languageChanged();
    }

    private toggleFullScreen(): void {
        if (document.fullscreenElement) void document.exitFullscreen();
        else void document.documentElement.requestFullscreen?.();
    }
}
