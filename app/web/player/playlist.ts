// SPDX-License-Identifier: GPL-3.0-or-later
// The animations to choose from: list.json beside the page, which `sandreel-cli export-player` writes.

export interface ListItem {
    name: string;
    /// Both relative to the page.
    file: string;
    picture?: string;
}

function isItem(item: unknown): item is ListItem {
    const { name, file, picture } = (item ?? {}) as Record<string, unknown>;
    return typeof name === 'string' && typeof file === 'string' && ['string', 'undefined'].includes(typeof picture);
}

/// Empty where there is no list: files can be dropped all the same.
export async function loadPlayList(): Promise<ListItem[]> {
    const response = await fetch(new URL('list.json', document.baseURI), { cache: 'no-cache' });
    if (!response.ok) return [];
    const list = (await response.json()) as { animations?: unknown };
    return Array.isArray(list.animations) ? list.animations.filter(isItem) : [];
}

/// Fills the list. `choose` is called with the index of the item that was picked.
export function showPlayList(list: HTMLElement, items: ListItem[], choose: (index: number) => void): void {
    list.replaceChildren(...items.map((item, index) => {
        const button = document.createElement('button');
        button.type = 'button';
        const name = document.createElement('span');
        name.textContent = item.name;
        button.title = item.name;
        let picture: HTMLElement;
        if (item.picture) {
            const image = document.createElement('img');
            image.src = item.picture;
            image.alt = '';
            image.loading = 'lazy';
            picture = image;
        } else {
            picture = document.createElement('div');
            picture.className = 'blank';
        }
        button.append(picture, name);
        button.onclick = () => choose(index);
        const entry = document.createElement('li');
        entry.append(button);
        return entry;
    }));
}

export function markChosen(list: HTMLElement, chosen: number): void {
    list.querySelectorAll('button').forEach((button, index) => {
        if (index === chosen) button.setAttribute('aria-current', 'true');
        else button.removeAttribute('aria-current');
        if (index === chosen) button.scrollIntoView({ block: 'nearest', inline: 'nearest' });
    });
}
