// Helpers of the tests of a page's controls: what it shows, and changes like those of a user.

export const time = (page) => page.$eval('#timeline', (slider) => Number(slider.getAttribute('aria-valuenow')));
export const shown = (page, id) => page.$eval(id, (element) => element.textContent);
export const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
export const sample = (page, t) => page.evaluate((at) => globalThis.twrench.sample(at), t);
export const still = { features: [{ name: 'prefers-reduced-motion', value: 'reduce' }] };

/** Changes a control like a user who types into it or chooses from it. */
export async function enter(page, selector, text) {
  await page.click(selector, { count: 3 });
  await page.keyboard.type(text);
  await page.keyboard.press('Tab');
  await settle(page);
}

export const copied = async (page, button) => {
  await page.click(button);
  await page.waitForFunction(() => !document.getElementById('copied').hidden && document.getElementById('copied').textContent);
  return shown(page, '#copied');
};

/** The text of the file that a button saves. */
export async function saved(page, button) {
  await page.evaluate(() => {
    globalThis.savedText = null;
    const create = URL.createObjectURL;
    URL.createObjectURL = (blob) => (blob.text().then((text) => (globalThis.savedText = text)), create(blob));
    HTMLAnchorElement.prototype.click = () => {};
  });
  await page.click(button);
  await page.waitForFunction(() => globalThis.savedText);
  return page.evaluate(() => globalThis.savedText);
}
