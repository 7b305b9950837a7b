// The page that fills the middle of the console.
import { Store } from './store';

export type Page = 'live' | 'regions' | 'review' | 'space';

export const page = new Store<Page>('live');
