// SPDX-License-Identifier: GPL-3.0-or-later
// Every text of the page in both languages. Errors have the words of model/io/errortext.cpp.
import type { NamedError } from './decoder';

const english = {
    title: 'Sandreel Player',
    animations: 'Animations',
    view: 'Animation',
    play: 'Play',
    pause: 'Pause',
    stepBack: 'Step Back',
    stepForward: 'Step Forward',
    firstFrame: 'First Frame',
    lastFrame: 'Last Frame',
    loop: 'Loop',
    frame: 'Frame',
    rate: 'Frames per second',
    rateShort: 'frames/s',
    style: 'Draw As',
    shaded: 'Shaded',
    wireframe: 'Wireframe',
    points: 'Points',
    density: 'Density of points',
    fit: 'Fit View',
    fullScreen: 'Full Screen',
    enterXr: 'Headset',
    open: 'Open File…',
    openHint: 'or drop an .anim file here',
    language: 'Česky',
    keys: 'Keys',
    keysTitle: 'Keyboard',
    close: 'Close',
    loading: 'Loading %1',
    frameOf: 'Frame %1 of %2',
    info: '%1 vertices · %2 triangles · %3 frames',
    quality: '%1 of %2 trajectories',
    empty: 'No animations here yet',
    keySpace: 'Play or pause',
    keyArrows: 'One frame back or forward',
    keyEnds: 'First or last frame',
    keyTurn: 'Turn',
    keyZoom: 'Zoom in or out',
    keyStyle: 'Shaded, wireframe, points',
    keyRate: 'Slower or faster',
    keyLoop: 'Loop on or off',
    keyFit: 'Fit view',
    keyFull: 'Full screen',
    keyList: 'Previous or next animation',
    noWebGl: 'This browser cannot draw in 3D: WebGL 2 is missing or switched off.',
    notAnim: '“%1” is not an .anim file.',
    cannotStart: 'The player cannot start: %1',
};

export type TextKey = keyof typeof english;

const czech: Record<TextKey, string> = {
    title: 'Přehrávač Sandreel',
    animations: 'Animace',
    view: 'Animace',
    play: 'Přehrát',
    pause: 'Pozastavit',
    stepBack: 'O snímek zpět',
    stepForward: 'O snímek vpřed',
    firstFrame: 'První snímek',
    lastFrame: 'Poslední snímek',
    loop: 'Opakovat',
    frame: 'Snímek',
    rate: 'Snímků za sekundu',
    rateShort: 'snímků/s',
    style: 'Zobrazit jako',
    shaded: 'Stínované',
    wireframe: 'Drátový model',
    points: 'Body',
    density: 'Hustota bodů',
    fit: 'Přizpůsobit pohled',
    fullScreen: 'Celá obrazovka',
    enterXr: 'Brýle',
    open: 'Otevřít soubor…',
    openHint: 'nebo sem přetáhněte soubor .anim',
    language: 'English',
    keys: 'Klávesy',
    keysTitle: 'Klávesnice',
    close: 'Zavřít',
    loading: 'Načítá se %1',
    frameOf: 'Snímek %1 z %2',
    info: '%1 vrcholů · %2 trojúhelníků · %3 snímků',
    quality: '%1 z %2 trajektorií',
    empty: 'Zatím tu nejsou žádné animace',
    keySpace: 'Přehrát nebo pozastavit',
    keyArrows: 'O snímek zpět nebo vpřed',
    keyEnds: 'První nebo poslední snímek',
    keyTurn: 'Otáčet',
    keyZoom: 'Přiblížit nebo oddálit',
    keyStyle: 'Stínované, drátový model, body',
    keyRate: 'Pomaleji nebo rychleji',
    keyLoop: 'Opakování zapnout nebo vypnout',
    keyFit: 'Přizpůsobit pohled',
    keyFull: 'Celá obrazovka',
    keyList: 'Předchozí nebo další animace',
    noWebGl: 'Tento prohlížeč neumí kreslit ve 3D: WebGL 2 chybí nebo je vypnuté.',
    notAnim: '„%1“ není soubor .anim.',
    cannotStart: 'Přehrávač nelze spustit: %1',
};

const englishErrors: Record<string, string> = {
    Truncated: 'The file ends too early: %1 bytes are needed, %2 are there. It may have been copied incompletely.',
    TrailingBytes: 'There are %1 bytes too many at the end. The file may be damaged.',
    BadMagic: 'The file is not a %1 file: it does not start as one.',
    UnsupportedVersion: 'The file has format version %1, but this player reads versions up to %2.',
    UnsupportedFeature: 'The file uses something that cannot be read: %1.',
    ChecksumMismatch: 'The file is damaged: the checksum of its part “%1” is wrong.',
    MissingChunk: 'The file is damaged: its part “%1” is missing.',
    DuplicateChunk: 'The file is damaged: it has its part “%1” twice.',
    BadValue: 'The file is damaged: %1 is %2, but must be %3.',
    UnknownCodec: 'The file was compressed with method %1, which this player does not know.',
    CorruptStream: 'The compressed data are damaged (%1).',
    LimitExceeded: 'Too large: %1 is %2, the limit is %3.',
    OutOfMemory: 'There is not enough memory for this file.',
    DecoderStopped: 'The file cannot be decoded: it is damaged.',
    CannotLoad: 'The file cannot be loaded: %1.',
    TooLargeForGpu: 'The mesh is too large for this device.',
    UnknownError: 'The file cannot be opened.',
};

const czechErrors: Record<string, string> = {
    Truncated: 'Soubor končí příliš brzy: potřeba je %1 bajtů, k dispozici %2. Možná se nezkopíroval celý.',
    TrailingBytes: 'Na konci přebývá bajtů: %1. Soubor může být poškozený.',
    BadMagic: 'Toto není soubor %1: nezačíná tak.',
    UnsupportedVersion: 'Soubor má verzi formátu %1, tento přehrávač čte verze nejvýše %2.',
    UnsupportedFeature: 'Soubor používá něco, co nelze přečíst: %1.',
    ChecksumMismatch: 'Soubor je poškozený: kontrolní součet části „%1“ nesouhlasí.',
    MissingChunk: 'Soubor je poškozený: chybí část „%1“.',
    DuplicateChunk: 'Soubor je poškozený: část „%1“ je v něm dvakrát.',
    BadValue: 'Soubor je poškozený: %1 je %2, ale musí být %3.',
    UnknownCodec: 'Soubor je komprimovaný metodou %1, kterou tento přehrávač nezná.',
    CorruptStream: 'Komprimovaná data jsou poškozená (%1).',
    LimitExceeded: 'Příliš velké: %1 je %2, mez je %3.',
    OutOfMemory: 'Na tento soubor není dost paměti.',
    DecoderStopped: 'Soubor nelze dekódovat: je poškozený.',
    CannotLoad: 'Soubor nelze načíst: %1.',
    TooLargeForGpu: 'Síť je pro toto zařízení příliš velká.',
    UnknownError: 'Soubor nelze otevřít.',
};

export type Language = 'en' | 'cs';

const LanguageKey = 'sandreel-language';

function stored(): string | null {
    try {
        return localStorage.getItem(LanguageKey);
    } catch {
        return null; // switched off
    }
}

let current: Language = ((stored() ?? navigator.language).startsWith('cs')) ? 'cs' : 'en';

export function language(): Language {
    return current;
}

export function setLanguage(language: Language): void {
    current = language;
    try {
        localStorage.setItem(LanguageKey, language);
    } catch {
        // Not kept then.
    }
}

function filled(pattern: string, args: string[]): string {
    return pattern.replace(/%(\d)/g, (_, n: string) => args[Number(n) - 1] ?? '');
}

export function text(key: TextKey, ...args: (string | number)[]): string {
    const shown = args.map((arg) => (typeof arg === 'number' ? arg.toLocaleString(current) : arg));
    return filled((current === 'cs' ? czech : english)[key], shown);
}

export function errorText(error: NamedError): string {
    const texts = current === 'cs' ? czechErrors : englishErrors;
    return filled(texts[error.name] ?? texts.UnknownError, error.args);
}
